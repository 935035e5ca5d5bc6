// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls: recognition, blocks, labels, parameters, notes. Where G-code has
// the same move, the motions of both programs are compared.
#include "ncsim/gcode/klartext.h"

#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ncsim::gcode::klartext_test {
namespace {

// --- Recognition ---

TEST(Klartext, IsRecognisedByBeginPgm) {
    const Made r =
        run("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+1 Y+2 Z+3 FMAX\n3 END PGM A MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.result.dialect.dialect, Dialect::Heidenhain);
    EXPECT_TRUE(r.result.ended);
    EXPECT_EQ(r.moves.size(), 1U);
}

TEST(Klartext, IsRecognisedWithoutNumbers) {
    const Files files{{"PART.H", klartext("L X+5 F100")}};
    const Made r = run("BEGIN PGM A MM\nCALL PGM PART.H\nEND PGM A MM\n", files);
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves.size(), 2U);
    const Made text = run("Write TOOL CALL in a line of its own.\n");
    EXPECT_NE(text.errors(), "");
}

TEST(Klartext, IsChosenByTheUserWithoutSigns) {
    const Made r = run("L X+1\n", {}, Dialect::Heidenhain);
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves.size(), 1U);
}

TEST(Klartext, DoesNotRunUnderTheDialectOfAnotherControl) {
    const Made r = run(klartext("L X+1"), {}, Dialect::Fanuc);
    EXPECT_TRUE(r.says("foreign-kind"));
}

TEST(Klartext, CHeaderIsNoKlartext) {
    const SourceFile header{"a.h", "#ifndef A_H\n#define A_H\nint f(int x);\n#endif\n"};
    EXPECT_FALSE(is_klartext(header));
    EXPECT_NE(detect_dialect(header).kind, Kind::Heidenhain);
}

// --- Blocks ---

TEST(Klartext, LineIsNeverModal) {
    expect_refused(
        "10 +20",
        "4:4: '+20' is no block of Klartext; the program is stopped here [klartext-verb]");
}

TEST(Klartext, LineWithWordsInAnyOrder) {
    expect_same("L M8 Z-1 F200 X+10 R0 Y-5", "G1 Z-1. F200 X10. Y-5. M8");
}

TEST(Klartext, NumbersWithCommaPointOrNoSign) {
    expect_same("L X10,5 Y.5 Z-0.25 F100", "G1 X10.5 Y0.5 Z-0.25 F100");
}

TEST(Klartext, BlocksWithoutBlanks) {
    expect_same("L X+10Y+20Z-5F100", "G1 X10. Y20. Z-5. F100");
}

TEST(Klartext, FmaxAppliesToOneBlock) {
    expect_same("L X+10 F200\nL Y+10 FMAX\nL X+0\nL Y+0 F MAX\nL X+5",
                "G1 X10. F200\nG0 Y10.\nG1 X0.\nG0 Y0.\nG1 X5.");
}

TEST(Klartext, FautoIsTheFeedOfToolCall) {
    expect_same("TOOL CALL 1 Z S1000 F333\nL X+1 F50\nL X+2 F AUTO\nL X+3 FAUTO",
                "G1 X1. F50\nX2. F333\nX3.");
}

TEST(Klartext, WordsThatWereLeftEmptyChangeNothing) {
    expect_same("L X+1 F100\nL X+2 R F MAX M\nL X+3 R F M8", "G1 X1. F100\nG0 X2.\nG1 X3. M8");
}

TEST(Klartext, FeedPerTooth) {
    expect_refused(
        "L X+1 FZ0.1",
        "4:7: a feed per tooth (FZ) is not read; the program is stopped here [klartext-verb]");
}

TEST(Klartext, InchProgramsCountTenthsOfAnInchPerMinute) {
    const Made r =
        run("BEGIN PGM T INCH\nTOOL CALL 1 Z S1000\nL X+1 Y+0 Z+0 F100\nL X+2\nEND PGM T INCH\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_DOUBLE_EQ(r.end().x.mm(), 50.8);
    EXPECT_DOUBLE_EQ(r.moves.back().feed, 254.0);
    EXPECT_TRUE(r.result.uses_inches);
    EXPECT_TRUE(r.result.units_stated);
}

TEST(Klartext, IncrementPerWord) {
    expect_same("L X+10 Y+10 F100\nL IX+5 Y+20\nL X+1 IY-3 IZ-2",
                "G1 X10. Y10. F100\nX15. Y20.\nX1. Y17. Z48.");
}

TEST(Klartext, IncrementsFromAnUnknownPlaceAreRelative) {
    const Made r = run("BEGIN PGM T MM\nL IX+10 F100\nL IX+10\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.moves.back().start_assumed);
}

TEST(Klartext, CommentsHeadingsAndContinuedLines) {
    const Made r = run(klartext(
        "* - PART 1\n; text\n(text)\n5\nL X+10 ~\n Y+20 ; here\nL Z+1 (TEXT) FMAX ;~\nnot code"));
    expect_end(r, 10, 20, 1);
}

TEST(Klartext, BlockNumbersMayLackOrHaveGaps) {
    const std::string a = "BEGIN PGM T MM\nTOOL CALL 1 Z\nL X+1 Y+2 Z+3 FMAX\nEND PGM T MM\n";
    const std::string b =
        "7 BEGIN PGM T MM\n90 TOOL CALL 1 Z\n12 L X+1 Y+2 Z+3 FMAX\n3 END PGM T MM\n";
    EXPECT_EQ(run(a).texts, run(b).texts);
}

TEST(Klartext, BlockDelete) {
    const std::string text = klartext("/L X+10 F100\n5 /L Y+5\n/ 6 L Z+1");
    EXPECT_EQ(run(text).moves.size(), 4U);
    EXPECT_EQ(run(text, {}, Dialect::Auto, true).moves.size(), 1U);
    EXPECT_TRUE(run(text).result.deletable.has_value());
}

TEST(Klartext, LineEndsAndUmlautsChangeNothing) {
    std::string text = klartext("; Fr\xE4ser\n; Fr\x84ser\n; Fr\xC3\xA4ser\nL X+10 F100\n* - \xFC");
    const Made a = run(text);
    std::string dos;
    for (const char c : text)
        dos += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(run(dos).texts, a.texts);
    EXPECT_EQ(run("\xEF\xBB\xBF" + text).texts, a.texts);
}

TEST(Klartext, TextBeforeBeginPgmIsLeftOut) {
    const Made r = run("=====\nInformation listing\n" + klartext("L X+1 F100"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("klartext-head"));
}

TEST(Klartext, AxesWithoutVerb) {
    expect_same("X+5 Z+1 F100\nC+20 FMAX", "G1 X5. Z1. F100\nG0 C20.");
}

// --- Labels, calls, repeats ---

TEST(Klartext, RepeatRunsOnceMoreThanRep) {
    for (const char* rep : {"REP2", "REP 2", "REP 2/2", "REPQ1"}) {
        const Made r = run(klartext(std::string("Q1 = 2\nLBL 1\nL IX+1 F100\nCALL LBL 1 ") + rep));
        expect_end(r, 3, 0, 50);
    }
}

TEST(Klartext, RepeatEqualsUnrolled) {
    EXPECT_EQ(run(klartext("LBL 1\nL IX+1 F100\nL IY+1\nCALL LBL 1 REP2")).texts,
              run(klartext("L IX+1 F100\nL IY+1\nL IX+1\nL IY+1\nL IX+1\nL IY+1")).texts);
}

TEST(Klartext, RepeatsNest) {
    const Made r =
        run(klartext("LBL 1\nLBL 2\nL IX+1 F100\nCALL LBL 2 REP1\nL IY+1\nCALL LBL 1 REP2"));
    expect_end(r, 6, 3, 50);
}

TEST(Klartext, RepeatLeftByAJumpDoesNotStay) {
    const Made r =
        run(klartext("LBL 1\nQ1 = 0\nLBL 2\nL IX+1 F100\nQ1 = Q1 + 1\nFN 9: IF +Q1 EQU +2 GOTO LBL "
                     "3\nCALL LBL 2 REP5\nLBL 3\nCALL LBL 1 REP2"));
    expect_end(r, 6, 0, 50);
}

TEST(Klartext, BlockAfterACommentWithTildeIsNotLost) {
    expect_end(run(klartext("L X+1 F100 ; text ~\nL Y+2\n5 L Z+3 ; text ~\n6 L IX+1")), 2, 2, 3);
}

TEST(Klartext, SubprogramRunsUpToLabelZero) {
    const Made r =
        run("BEGIN PGM T MM\nL X+0 Y+0 Z+0 FMAX\nCALL LBL 5\nCALL LBL \"NAME\"\nM30\nLBL 5\nL IX+1 "
            "F100\nLBL 0\nLBL \"NAME\"\nL IY+1\nLBL 0\nEND PGM T MM\n");
    expect_end(r, 1, 1, 0);
}

TEST(Klartext, SubprogramRunsWhereItStands) {
    const Made r = run(klartext("LBL 5\nL IX+1 F100\nLBL 0\nCALL LBL 5"));
    expect_end(r, 2, 0, 50);
}

TEST(Klartext, LabelsByQAndQs) {
    const Made r =
        run(klartext("Q1 = 5\nQS2 = \"AB\"\nCALL LBL Q1\nCALL LBL QS2\nM30\nLBL 5\nL IX+1 "
                     "F100\nLBL 0\nLBL \"AB\"\nL IY+2\nLBL 0"));
    expect_end(r, 1, 2, 50);
}

TEST(Klartext, LabelMissing) {
    expect_refused("CALL LBL 7",
                   "4:1: there is no LBL 7; the program is stopped here [label-missing]");
    expect_refused("CALL LBL \"A\"",
                   "4:1: there is no LBL \"A\"; the program is stopped here [label-missing]");
}

TEST(Klartext, CallsNest) {
    const Made r = run(klartext(
        "CALL LBL 1\nM30\nLBL 1\nL IX+1 F100\nCALL LBL 2\nL IX+1\nLBL 0\nLBL 2\nL IY+1\nLBL 0"));
    expect_end(r, 2, 1, 50);
}

TEST(Klartext, EndlessCallsAreErrors) {
    EXPECT_TRUE(run(klartext("LBL 1\nCALL LBL 1\nLBL 0")).says("call-depth"));
    EXPECT_TRUE(run(klartext("CALL PGM A"), {{"A", "CALL PGM A\n"}}).says("call-depth"));
    EXPECT_TRUE(run(klartext("LBL 1\nFN 9: IF +1 EQU +1 GOTO LBL 1")).says("step-limit"));
    EXPECT_TRUE(run(klartext("LBL 1\nL IX+1 F9\nCALL LBL 1 REP 999999999")).says("step-limit"));
}

TEST(Klartext, CallPgmWithoutFolderAndEnding) {
    for (const char* call :
         {"CALL PGM TNC:\\PART\\SUB.H", "CALL PGM SUB", "CALL PGM \"SUB.H\"", "CALL PGMSUB"}) {
        const Made r = run(klartext(std::string(call) + "\nL IX+1"),
                           {{"SUB.H", "0 BEGIN PGM SUB MM\n1 L IY+1 F100\n2 END PGM SUB MM\n"}});
        expect_end(r, 1, 1, 50);
        EXPECT_EQ(r.result.files.size(), 2U);
    }
}

TEST(Klartext, MissingProgramIsLeftOutWithADoubt) {
    const Made r = run(klartext("L X+1 F100\nCALL PGM TNC:\\PART\\NO.H\nL IX+1"));
    expect_end(r, 2, 0, 50);
    EXPECT_TRUE(r.says("program-not-found"));
    EXPECT_TRUE(r.result.ended);
}

TEST(Klartext, FoldersOfACalledProgramAreNotLookedAt) {
    const Files files{{"../NO.H", "L X+9 F100\n"}, {"/etc/NO.H", "L X+9 F100\n"}};
    for (const char* call : {"CALL PGM ../NO.H", "CALL PGM \"/etc/NO.H\"", "CALL PGM ..\\NO"}) {
        const Made r = run(klartext("L X+1 F100\n" + std::string(call)), files);
        expect_end(r, 1, 0, 50);
        EXPECT_TRUE(r.says("program-not-found")) << call;
    }
}

TEST(Klartext, MissingProgramEndsCompensation) {
    const Made r = run(klartext("L X+20 RL F100\nL Y+20\nCALL PGM NO\nL X+0"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_FALSE(r.says("left-on"));
}

TEST(Klartext, CallPgmWithTheEndingOfTheMainProgram) {
    const Made r =
        language_test::run(klartext("CALL PGM100\nL IX+1"), {{"100.nc", "L IY+1 F100\n"}},
                           Dialect::Auto, false, "PART/MAIN.nc");
    expect_end(r, 1, 1, 50);
}

TEST(Klartext, CalledProgramEqualsPasted) {
    const std::string part = "L X+5 F100\nL Y+7\nCC X+0 Y+7\nCP IPA+90 DR+\n";
    EXPECT_EQ(run(klartext("CALL PGM SUB"), {{"SUB", part}}).texts, run(klartext(part)).texts);
}

TEST(Klartext, CallPgmKeepsTransformationsAndTheTool) {
    const Made r =
        run(klartext("CALL PGM SUB\nL X+1 Y+0 F100"),
            {{"SUB", "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nTOOL CALL 2 Z S9\n"}});
    expect_end(r, 0, 1, 50);
    EXPECT_EQ(r.moves.back().tool, 2);
}

TEST(Klartext, OutputsOfFnHaveNoEffect) {
    const Made r =
        run(klartext("FN 16: F-PRINT TNC:\\A.A / TNC:\\B.TXT\nFN 19: PLC=+10/+1\n"
                     "FN 20: WAIT FOR SYNC\nL X+1 FMAX"));
    expect_end(r, 1, 0, 50);
    EXPECT_EQ(r.moves.size(), 2U);
}

TEST(Klartext, QIsGlobalAndQlIsLocal) {
    const Made r = run(klartext("Q1 = 3\nQL1 = 4\nCALL PGM SUB\nL X+Q1 Y+QL1 F100"),
                       {{"SUB", "Q1 = 7\nQL1 = 9\n"}});
    expect_end(r, 7, 4, 50);
}

// --- Q parameters ---

TEST(Klartext, FormulasAndFn) {
    const Made r =
        run(klartext("FN 0: Q1 =+5\nFN 1: Q2 = +Q1 + +2\nFN 2: Q3 = +Q2 - 3\nFN 3: Q4 = +Q3 * -2\n"
                     "FN 4: Q5 = +Q4 DIV +4\nFN 5: Q6 = SQRT +16\nFN 8: Q7 = +3 LEN +4\n"
                     "Q8 = ( Q1 + Q2 ) * 2 - SQ 3 + SQRT 16 / 2 ^ 2\nQR9 = - 1.5\n"
                     "L X+Q8 Y-QR9 Z+Q5 F100"));
    expect_end(r, 16, 1.5, -2);
}

TEST(Klartext, AnglesAreInDegrees) {
    const Made r =
        run(klartext("Q1 = SIN 30 + COS 60\nFN 6: Q2 = SIN +90\nFN 13: Q3 = +1 ANG -1\nQ4 = ATAN "
                     "1\nL X+Q1 Y+Q3 Z+Q4 FMAX\nL IX+Q2"));
    expect_end(r, 2, 135, 45);
}

TEST(Klartext, Branches) {
    const std::string loop = "Q1 = 0\nLBL 1\nL IX+1 F100\nQ1 = Q1 + 1\n";
    expect_end(run(klartext(loop + "FN 12: IF +Q1 LT +5 GOTO LBL 1")), 5, 0, 50);
    expect_end(run(klartext(loop + "IF +Q1 NE +4 GOTO LBL 1")), 4, 0, 50);
    expect_end(run(klartext(loop + "FN 11: IF +3 GT +Q1 GOTO LBL 1")), 3, 0, 50);
    expect_end(run(klartext(loop + "FN9: IF +Q1 EQU +1 GOTO LBL 1")), 2, 0, 50);
}

TEST(Klartext, UnsetParameterIsZeroWithADoubt) {
    const Made r = run(klartext("L X+Q5 F100"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("variable-unknown"));
    EXPECT_FALSE(run(klartext("Q5 = 1\nL X+Q5 F100")).says("variable-unknown"));
}

TEST(Klartext, SystemDataAreUnknown) {
    EXPECT_TRUE(run(klartext("FN 18: SYSREAD Q1 = ID20 NR1")).says("variable-unknown"));
}

TEST(Klartext, Fn14StopsWithAnAlarm) {
    const Made r = run(klartext("FN 14: ERROR = 1000\nL X+1 F100"));
    EXPECT_TRUE(r.says("control-alarm"));
    EXPECT_EQ(r.moves.size(), 1U);
}

TEST(Klartext, FeedByQ) {
    expect_same("Q50 = 300\nL X+1 FQ50\nL X+2 F+Q50", "G1 X1. F300\nX2.");
}

TEST(Klartext, FaultsOfFormulas) {
    EXPECT_TRUE(run(klartext("Q1 = 1 / 0")).says("division-by-zero"));
    EXPECT_TRUE(run(klartext("Q1 = SQRT - 1")).says("function-range"));
    EXPECT_TRUE(run(klartext("Q1 = ( 1")).says("bracket-unclosed"));
    EXPECT_TRUE(run(klartext("Q1 = " + std::string(500, '('))).says("expression-too-deep"));
    EXPECT_TRUE(run(klartext("Q99999 = 1")).says("parameter-range"));
    EXPECT_TRUE(run(klartext("Q1 = 10 ^ 300")).says("not-a-number"));
}

TEST(Klartext, RejectedBlocksAreErrors) {
    expect_refused(
        "ERROR = L XQ1 + 2",
        "4:1: the control rejected this block; the program is stopped here [control-error]");
}

// --- Comments, stock, listing ---

TEST(Klartext, NotesHaveCommentsToolsAndStock) {
    const SourceFile file{"t.h",
                          "0 BEGIN PGM T MM\n1 BLK FORM 0.1 Z X0 Y0 Z-20,5\n2 BLK FORM 0.2 IX100 "
                          "IY50 IZ20\n3 * - MILL D10\n4 ; #3 D=8 - drill\n5 TOOL CALL \"FR_D6\" Z "
                          "S100\n6 TOOL DEF 4 L+10 R+3\n7 L X+1 FMAX\n8 END PGM T MM\n"};
    KlartextNotes notes(file);
    Block block;
    std::vector<std::string> texts;
    std::string words;
    while (notes.next(block)) {
        for (const Comment& comment : block.comments)
            texts.emplace_back(comment.text);
        for (const Word& word : block.words)
            words += word.letter;
    }
    const std::vector<std::string> expected{"BLK FORM 0.1 Z X+0 Y+0 Z-20.5",
                                            "BLK FORM 0.2 X+100 Y+50 Z-0.5",
                                            "MILL D10",
                                            "T3 D=8 - drill",
                                            "T9001 FR D6",
                                            "T4 D=6 CR=0 - flat end mill"};
    EXPECT_EQ(texts, expected);
    EXPECT_EQ(words, "GTGX");
}

TEST(Klartext, RoundBlank) {
    const auto found = klartext_cylinder(
        {"t.h", "BEGIN PGM T MM\nBLK FORM CYLINDER Z R50 L105 DIST+5\nEND PGM T MM\n"});
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->axis, 2);
    EXPECT_EQ(found->radius.mm(), 50.0);
    EXPECT_EQ(found->length.mm(), 105.0);
    EXPECT_EQ(found->top.mm(), 5.0);
}

TEST(Klartext, ListingHasOneLineABlock) {
    const SourceFile file{"t.h",
                          "0 BEGIN PGM T MM\n1  L   X+1\tR0 ; text\n; text\n2 CYCL DEF 247 ~\n  "
                          "Q339=1 ;N\nwhat is this\n"};
    KlartextListing listing(file);
    ListedBlock line;
    DiagnosticLog log;
    std::vector<std::string> lines;
    while (listing.next(line, log))
        lines.push_back(std::to_string(line.line) + " " + line.text);
    EXPECT_EQ(lines, (std::vector<std::string>{"1 BEGIN PGM T MM", "2 L X+1 R0",
                                               "4 CYCL DEF 247 Q339=1", "6 what is this"}));
    EXPECT_EQ(log.errors(), 1U);
}

// --- Hostile input ---

TEST(Klartext, HugeNumbersAreErrors) {
    EXPECT_TRUE(run(klartext("L X+99999999999999999999999999 F100")).says("not-a-number"));
    EXPECT_TRUE(
        run(klartext(
                "CYCL DEF 200 X Q200=2 Q201=-1000000 Q206=1 Q202=0.0001 Q203=0\nL X+1 FMAX M99"))
            .says("cycle-repeats"));
    EXPECT_FALSE(run(klartext("TOOL CALL 99999999999 Z")).errors().empty());
}

TEST(Klartext, TruncatedBlocks) {
    for (const char* text : {"L",
                             "L X",
                             "L X+",
                             "CC X",
                             "C",
                             "CR",
                             "CP IPA",
                             "CT",
                             "RND",
                             "CHF",
                             "CYCL DEF",
                             "CYCL DEF 200",
                             "CYCL DEF 7.",
                             "CYCL CALL POS X",
                             "TOOL CALL",
                             "TOOL CALL \"",
                             "TOOL DEF",
                             "LBL",
                             "LBL \"",
                             "CALL LBL",
                             "CALL LBL 1 REP",
                             "CALL PGM",
                             "FN",
                             "FN 9:",
                             "FN 0: Q1",
                             "Q1 =",
                             "QS1 = \"",
                             "PLANE",
                             "PLANE SPATIAL SPA",
                             "FUNCTION",
                             "STOP M",
                             "BLK FORM",
                             "BEGIN PGM",
                             "END PGM",
                             "L M140 MB",
                             "~",
                             "\"",
                             "L X+1 ~",
                             ";~",
                             "*",
                             "/"}) {
        run(klartext(text));
        run(text, {}, Dialect::Heidenhain);
    }
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
