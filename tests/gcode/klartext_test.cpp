// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls. Each test is named after the construct. Where G-code has the
// same move, the motions of both programs are compared.
#include "ncsim/gcode/klartext.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Made {
    Interpretation result;
    std::vector<Motion> moves;       // Lines and arcs.
    std::vector<std::string> texts;  // All motions, without line numbers and tool changes.

    bool says(const std::string& code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [&](const Diagnostic& d) { return d.code == code; });
    }
    std::string errors() const {
        std::string out;
        for (const Diagnostic& d : result.diagnostics) {
            if (d.severity == Severity::Error)
                out += std::to_string(d.span.line) + ":" + std::to_string(d.span.column) + ": " +
                       d.message + " [" + d.code + "]\n";
        }
        return out;
    }
    Position end() const { return moves.empty() ? Position{} : *end_of(moves.back()); }
};

using Files = std::map<std::string, std::string, std::less<>>;

Made run(const std::string& text, const Files& files = {}, Dialect dialect = Dialect::Auto,
         bool block_delete = false) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.block_delete = block_delete;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.limits.repeated_blocks = 20'000;
    options.peck_clearance = 0.2;
    options.read_file = [&](std::string_view name) -> std::optional<SourceFile> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return SourceFile{found->first, found->second};
    };
    Made out;
    const SourceFile file{"test.h", text};
    out.result = interpret(file, options, [&](const Motion& motion) {
        if (start_of(motion)) out.moves.push_back(motion);
        if (std::holds_alternative<ToolChange>(motion.what)) return;
        std::string line;
        print(line, motion);
        out.texts.push_back(line.substr(line.find(' ') + 1));
    });
    return out;
}

/// A program with the tool T1 (D10) over X0 Y0 Z50.
std::string klartext(const std::string& blocks) {
    return "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\n" + blocks +
           "\nM30\nEND PGM T MM\n";
}
std::string iso(const std::string& blocks) {
    return "%\nO0001\nG21 G90 G17 G40 G80\nT1 M6\nG43 H1\nS1000 G0 X0. Y0. Z50. M3\n" + blocks +
           "\nM30\n%\n";
}

/// Compares the motions of both programs, word for word.
void expect_same(const std::string& of_klartext, const std::string& of_iso) {
    const Made a = run(klartext(of_klartext));
    const Made b = run(iso(of_iso), {}, Dialect::Fanuc);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(b.errors(), "");
    EXPECT_GT(a.texts.size(), 1U);
    EXPECT_EQ(a.texts, b.texts);
}

void expect_refused(const std::string& blocks, const std::string& error) {
    const Made r = run(klartext(blocks));
    EXPECT_EQ(r.errors(), error + "\n");
    EXPECT_TRUE(r.result.refused);
}

void expect_end(const Made& r, double x, double y, double z) {
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(r.end().x.mm(), x, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), y, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), z, 1e-9);
}

// --- Recognition ---

TEST(Klartext, IsRecognisedByBeginPgm) {
    const Made r =
        run("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+1 Y+2 Z+3 FMAX\n3 END PGM A MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.result.dialect.dialect, Dialect::Heidenhain);
    EXPECT_TRUE(r.result.ended);
    EXPECT_EQ(r.moves.size(), 1U);
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

// --- Arcs ---

TEST(Klartext, CircleAboutCentre) {
    expect_same("L X+10 Y+0 Z-1 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\nC X+10 Y+0 DR-",
                "G1 X10. Y0. Z-1. F100\nG3 X0. Y10. I-10. J0.\nG2 X10. Y0. I0. J-10.");
}

TEST(Klartext, FullCircle) {
    expect_same("L X+10 Y+0 F100\nCC X+0 Y+0\nC X+10 Y+0 DR+",
                "G1 X10. Y0. F100\nG3 X10. Y0. I-10. J0.");
}

TEST(Klartext, DirectionStaysWithoutDr) {
    expect_same("L X+10 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\nC X-10 Y+0",
                "G1 X10. F100\nG3 X0. Y10. I-10. J0.\nG3 X-10. Y0. I0. J-10.");
}

TEST(Klartext, CentreIsIncrementalFromTheLastPosition) {
    expect_same("L X+10 Y+5 F100\nCC IX-10 IY+0\nC X+0 Y+15 DR+",
                "G1 X10. Y5. F100\nG3 X0. Y15. I-10. J0.");
}

TEST(Klartext, CentreWithoutAxesIsTheLastPosition) {
    const Made r = run(klartext("L X+10 Y+5 F100\nCC\nLP PR+10 PA+90"));
    expect_end(r, 10, 15, 50);
}

TEST(Klartext, ArcNeedsACentre) {
    EXPECT_EQ(run(klartext("L X+1 F100\nC X+5 Y+5 DR+")).errors(),
              "5:1: C needs a centre (CC) before it; the block is left out [arc-without-centre]\n");
}

TEST(Klartext, CirclePolar) {
    expect_same("L X+10 Y+0 F100\nCC X+0 Y+0\nCP IPA+90 DR+\nCP PA+180 DR+",
                "G1 X10. Y0. F100\nG3 X0. Y10. I-10. J0.\nG3 X-10. Y0. I0. J-10.");
}

TEST(Klartext, CirclePolarAloneIsAFullCircle) {
    expect_same("L X+10 Y+0 F100\nCC X+0 Y+0\nCP DR-", "G1 X10. Y0. F100\nG2 X10. Y0. I-10. J0.");
}

TEST(Klartext, HelixOfNineTurns) {
    const Made r = run(klartext("L X+10 Y+0 Z+0 F100\nCC X+0 Y+0\nCP IPA+3240 IZ+13.5 DR+"));
    expect_end(r, 10, 0, 13.5);
    EXPECT_EQ(std::get<Arc>(r.moves.back().what).turns, 9);
}

TEST(Klartext, HelixWithPartOfATurn) {
    const Made r = run(klartext("L X+10 Y+0 Z+0 F100\nCC X+0 Y+0\nCP IPA-450 Z-5 DR-"));
    expect_end(r, 0, -10, -5);
    EXPECT_EQ(std::get<Arc>(r.moves.back().what).turns, -2);
}

TEST(Klartext, SignOfIpaAndDrMustBeEqual) {
    EXPECT_TRUE(run(klartext("L X+10 F100\nCC X+0 Y+0\nCP IPA+90 DR-")).says("direction-differs"));
}

TEST(Klartext, WholeTurnsFollowDr) {
    const Made r = run(klartext("L X+10 Y+0 Z+0 F100\nCC X+0 Y+0\nCP IPA+360 Z-2 DR-"));
    expect_end(r, 10, 0, -2);
    EXPECT_EQ(std::get<Arc>(r.moves.back().what).turns, -1);
}

TEST(Klartext, CircleByRadius) {
    expect_same("L X+10 Y+0 F100\nCR X+0 Y+10 R+10 DR+\nCR X+10 Y+0 R-10 DR+\nCR X+20 Y+0 R5 DR-",
                "G1 X10. Y0. F100\nG3 X0. Y10. R10.\nG3 X10. Y0. R-10.\nG2 X20. Y0. R5.");
}

TEST(Klartext, TangentialCircle) {
    // From X25 along +X the arc to X45 Y20 has the radius 20.
    const Made r = run(klartext("L X+0 Y+0 F100\nL X+25 Y+0\nCT X+45 Y+20\nL Y+40"));
    expect_end(r, 45, 40, 50);
    const auto& arc = std::get<Arc>(r.moves[3].what);
    EXPECT_NEAR(arc.centre_1.mm(), 25, 1e-9);
    EXPECT_NEAR(arc.centre_2.mm(), 20, 1e-9);
    EXPECT_EQ(arc.turns, 1);
    EXPECT_TRUE(run("BEGIN PGM T MM\nCT X+1 Y+1\nEND PGM T MM").says("tangent-missing"));
}

TEST(Klartext, PolarLines) {
    const Made r =
        run(klartext("CC X+50 Y+50\nLP PR+30 PA+0 F100\nLP IPA+90\nLP PA+180 Z-2\nLP IPR-10"));
    expect_end(r, 30, 50, -2);
}

TEST(Klartext, PlaneOfTheToolAxis) {
    const Made y =
        run("BEGIN PGM T MM\nTOOL CALL 1 Y S1\nL X+0 Y+0 Z+10 FMAX\nCC X+0 Z+0\nC X+10 Z+0 DR+ "
            "F100\nEND PGM T MM\n");
    EXPECT_EQ(y.errors(), "");
    EXPECT_EQ(std::get<Arc>(y.moves.back().what).plane, Plane::ZX);
    const Made x =
        run("BEGIN PGM T MM\nTOOL CALL 1 X S1\nL X+0 Y+10 Z+0 FMAX\nCC Y+0 Z+0\nC Y+0 Z+10 DR+ "
            "F100\nEND PGM T MM\n");
    EXPECT_EQ(x.errors(), "");
    EXPECT_EQ(std::get<Arc>(x.moves.back().what).plane, Plane::YZ);
}

// --- Corners ---

TEST(Klartext, Rounding) {
    expect_same("L X+0 Y+0 F100\nL X+20\nRND R5\nL Y+20\nRND 2 F50\nL X+0",
                "G1 X0. Y0. F100\nX20. ,R5.\nY20. ,R2.\nX0.");
}

TEST(Klartext, Chamfer) {
    expect_same("L X+0 Y+0 F100\nL X+20\nCHF 5\nL Y+20", "G1 X0. Y0. F100\nX20. ,C5.\nY20.");
}

TEST(Klartext, RoundingNextToAnArcIsRefused) {
    expect_refused(
        "L X+10 F100\nRND R1\nCR X+0 Y+10 R10 DR+",
        "5:1: RND next to an arc is not read; the program is stopped here [klartext-verb]");
}

// --- Cutter compensation ---

TEST(Klartext, CompensationIsModal) {
    expect_same("L X-20 Y-20 F100\nL X+0 Y-10 RL\nL Y+50\nL X+50\nL Y+0\nL X-20 R0\nL X-30 Y-30",
                "G1 X-20. Y-20. F100\nG41 D1 X0. Y-10.\nY50.\nX50.\nY0.\nG40 X-20.\nX-30. Y-30.");
}

TEST(Klartext, CompensationRight) {
    expect_same("L X-20 Y-20 F100\nL X+0 Y+0 RR\nL X+50\nL Y+50\nL X+70 Y+70 R0",
                "G1 X-20. Y-20. F100\nG42 D1 X0. Y0.\nX50.\nY50.\nG40 X70. Y70.");
}

TEST(Klartext, CompensationDoesNotBeginWithAnArc) {
    EXPECT_TRUE(
        run(klartext("L X+10 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+ RL")).says("compensation-entry"));
}

TEST(Klartext, BetweenRlAndRrABlockWithR0) {
    EXPECT_TRUE(run(klartext("L X+10 F100\nL X+20 RL\nL X+30 RR")).says("rl-change"));
}

TEST(Klartext, OversizeOfTheRadius) {
    const Made r =
        run("BEGIN PGM T MM\nTOOL CALL 1 Z S1 DR+0.5\nL X+0 Y+0 Z+0 FMAX\nL X+10 RL F100\nL "
            "X+20\nL X+30\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(end_of(r.moves[2])->y.mm(), 5.5, 1e-9);
}

TEST(Klartext, M97AndM98UnderCompensation) {
    EXPECT_TRUE(run(klartext("L X+10 RL F100\nL X+20 M97")).says("klartext-verb"));
    EXPECT_TRUE(run(klartext("L X+10 RL F100\nL X+20 M98")).says("klartext-verb"));
}

TEST(Klartext, CallPgmEndsCompensation) {
    const Made r = run(klartext("L X+10 RL F100\nL X+20\nCALL PGM SUB\nL X+30"),
                       {{"SUB", "BEGIN PGM SUB MM\nL X+25\nEND PGM SUB MM\n"}});
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(r.end().y.mm(), 0.0, 1e-9);
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
    expect_refused(
        "CALL PGM NO",
        "4:1: the program NO is not in the folder (--subprograms DIR names a folder with "
        "it); the program is stopped here [program-not-found]");
}

TEST(Klartext, CalledProgramEqualsPasted) {
    const std::string part = "L X+5 F100\nL Y+7\nCC X+0 Y+7\nCP IPA+90 DR+\n";
    EXPECT_EQ(run(klartext("CALL PGM SUB"), {{"SUB", part}}).texts, run(klartext(part)).texts);
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

// --- Tools and M codes ---

TEST(Klartext, ToolCallWithoutToolSetsTheSpeed) {
    const Made r = run(klartext("TOOL CALL Z S2500\nL X+1 F100"));
    EXPECT_EQ(r.moves.back().tool, 1);
    EXPECT_EQ(r.moves.back().spindle_rpm, 2500.0);
    EXPECT_EQ(r.moves.back().spindle, SpindleTurning::Clockwise);
}

TEST(Klartext, ToolByNameHasANumberOfItsOwn) {
    const Made r =
        run("BEGIN PGM T MM\nTOOL CALL \"FR_D10\" Z S100\nL X+1 Y+1 Z+1 FMAX\nTOOL CALL \"B2\" "
            "Z\nL X+2 FMAX\nTOOL CALL \"FR_D10\" Z\nL X+3 FMAX\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 3U);
    EXPECT_EQ(r.moves[0].tool, 9001);
    EXPECT_EQ(r.moves[1].tool, 9002);
    EXPECT_EQ(r.moves[2].tool, 9001);
}

TEST(Klartext, OversizeOfTheLengthIsRefused) {
    EXPECT_TRUE(
        run("BEGIN PGM T MM\nTOOL CALL 1 Z S1 DL+0.1\nEND PGM T MM\n").says("klartext-verb"));
    EXPECT_EQ(run("BEGIN PGM T MM\nTOOL CALL 1 Z S1 DL+0 DR+0 DR2+0\nEND PGM T MM\n").errors(), "");
}

TEST(Klartext, ToolDefWithRadius) {
    const Made r =
        run("BEGIN PGM T MM\nTOOL DEF 7 L+30,000 R+4,000\nTOOL CALL 7 Z S1\nL X+0 Y+0 Z+0 FMAX\nL "
            "X+10 RL F100\nL X+20\nL X+30\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(end_of(r.moves[2])->y.mm(), 4.0, 1e-9);
}

TEST(Klartext, M91IsTheMachineInThisBlock) {
    expect_same("L Z+0 R0 FMAX M91\nL X+5 F100", "G53 G0 Z0.\nG1 X5. F100");
}

TEST(Klartext, M92IsADoubt) {
    EXPECT_TRUE(run(klartext("L Z+0.0 R0 FMAX M92")).says("machine-point"));
}

TEST(Klartext, M140RetractsAlongTheToolAxis) {
    expect_same("L X+5 Z+1 F100\nL M140 MB 50 F750\nL M140 MB10\nL X+6",
                "G1 X5. Z1. F100\nG91 G1 Z50. F750\nG0 Z10.\nG90 G1 X6. F100");
    expect_same("L X+5 F100\nL M140 MB MAX", "G1 X5. F100\nG53 G0 Z0.");
}

TEST(Klartext, FeedPerRevolution) {
    expect_same("M136\nL X+1 F0.2\nM137\nL X+2 F100", "G95 G1 X1. F0.2\nG94 G1 X2. F100");
}

TEST(Klartext, SpindleAndCoolantStopAtTheEndOfTheBlock) {
    const Made r = run(klartext("L X+1 F100 M13\nL X+2 M5 M9\nL X+3"));
    ASSERT_EQ(r.moves.size(), 4U);
    EXPECT_EQ(r.moves[2].spindle, SpindleTurning::Clockwise);
    EXPECT_TRUE(r.moves[2].coolant.flood);
    EXPECT_EQ(r.moves[3].spindle, SpindleTurning::Stopped);
    EXPECT_FALSE(r.moves[3].coolant.flood);
}

TEST(Klartext, M126TurnsTheShortWay) {
    const Made r = run(klartext("L C+350 FMAX\nM126\nL C+10 FMAX\nM127\nL C+0 FMAX"));
    ASSERT_EQ(r.moves.size(), 4U);
    EXPECT_DOUBLE_EQ(end_of(r.moves[2])->c.degrees(), 370.0);
    EXPECT_DOUBLE_EQ(end_of(r.moves[3])->c.degrees(), 0.0);
}

TEST(Klartext, M128IsTipControl) {
    const Made r = run(klartext("L M128 F3000\nL X+1 A+10 F100\nM129\nL X+2"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(r.moves[1].feed, 100.0);
    EXPECT_EQ(r.moves[2].coordinates, Coordinates::Axes);
    const Made t = run(klartext(
        "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X+1 F100\nFUNCTION RESET TCPM\nL X+2"));
    EXPECT_EQ(t.errors(), "");
    EXPECT_EQ(t.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(t.moves[2].coordinates, Coordinates::Axes);
}

TEST(Klartext, UnknownMIsAWarning) {
    EXPECT_TRUE(run(klartext("L X+1 F1 M777")).says("unknown-m"));
    EXPECT_FALSE(run(klartext("L X+1 F1 M117")).says("unknown-m"));
    EXPECT_TRUE(run(klartext("L X+1 F1 M118 X1")).says("klartext-verb"));
}

TEST(Klartext, StopBlock) {
    const Made r = run(klartext("STOP M5\nL X+1 F100"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves.back().spindle, SpindleTurning::Stopped);
}

// --- Cycles ---

const std::string kDrill =
    "CYCL DEF 200 BOHREN ~\n Q200=2 ;ABSTAND ~\n Q201=-20 ;TIEFE ~\n Q206=150 ;VORSCHUB ~\n"
    " Q202=20 ;ZUSTELLUNG ~\n Q210=0 ;OBEN ~\n Q203=+0 ;FLAECHE ~\n Q204=50 ;2. ABSTAND ~\n"
    " Q211=0 ;UNTEN\n";

TEST(Klartext, CycleRunsOnlyWhenCalled) {
    EXPECT_EQ(run(klartext(kDrill)).moves.size(), 1U);
    EXPECT_TRUE(run(klartext("L X+1 FMAX M99")).says("cycle-undefined"));
}

TEST(Klartext, Cycle200) {
    expect_same(
        kDrill + "L X+10 Y+10 FMAX M99\nL X+20 FMAX M99",
        "G99 G81 X10. Y10. Z-20. R2. F150\nG80 G0 Z50.\nG99 G81 X20. Z-20. R2. F150\nG80 G0 Z50.");
}

TEST(Klartext, CyclCallAndM89) {
    const Made a =
        run(klartext(kDrill + "L X+10 FMAX\nCYCL CALL\nL X+20 FMAX M99\nL X+30 FMAX M99"));
    const Made b =
        run(klartext(kDrill + "L X+10 FMAX M89\nL X+20 FMAX\nL X+30 FMAX M99\nL X+30 FMAX"));
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(a.texts.size() + 1, b.texts.size());
    EXPECT_TRUE(std::equal(a.texts.begin(), a.texts.end(), b.texts.begin()));
}

TEST(Klartext, CyclCallPos) {
    EXPECT_EQ(run(klartext(kDrill + "CYCL CALL POS X+10 Y+5 FMAX")).texts,
              run(klartext(kDrill + "L X+10 Y+5 FMAX M99")).texts);
}

TEST(Klartext, InfeedCountsFromTheSurface) {
    const Made r = run(
        klartext("CYCL DEF 200 X Q200=5 Q201=-3 Q206=100 Q202=1.2 Q203=0 Q204=0\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    std::vector<double> bottoms;
    for (const Motion& m : r.moves) {
        if (m.kind == MoveKind::Feed) bottoms.push_back(end_of(m)->z.mm());
    }
    ASSERT_EQ(bottoms.size(), 3U);
    EXPECT_NEAR(bottoms[0], -1.2, 1e-9);
    EXPECT_NEAR(bottoms[1], -2.4, 1e-9);
    EXPECT_NEAR(bottoms[2], -3.0, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), 5.0, 1e-9);
}

TEST(Klartext, CycleParametersWithoutContinuation) {
    EXPECT_EQ(run(klartext("CYCL DEF 200 DRILLING\nQ200 = 2 ;A\nQ201 = -20\nQ206 = 150\nQ202 = "
                           "20\nQ203 = +0\nQ204 = 50\nL X+10 Y+10 FMAX M99"))
                  .texts,
              run(klartext(kDrill + "L X+10 Y+10 FMAX M99")).texts);
}

TEST(Klartext, DepthPositiveOrZero) {
    EXPECT_TRUE(run(klartext("CYCL DEF 200 X Q200=2 Q201=+3 Q206=1 Q202=3 Q203=0\nL X+1 FMAX M99"))
                    .says("depth-positive"));
    const Made zero =
        run(klartext("CYCL DEF 200 X Q200=2 Q201=0 Q206=1 Q202=3 Q203=0\nL X+1 FMAX M99"));
    EXPECT_TRUE(zero.says("depth-zero"));
    EXPECT_EQ(zero.moves.size(), 2U);
}

TEST(Klartext, CycleParameterMissing) {
    expect_refused("CYCL DEF 200 X Q200=2 Q201=-5 Q203=0\nL X+1 FMAX M99",
                   "5:1: cycle 200 needs Q206; the program is stopped here [cycle-parameter]");
}

TEST(Klartext, SecondClearanceNeverDown) {
    const Made r = run(
        klartext("CYCL DEF 200 X Q200=10 Q201=-5 Q206=100 Q202=5 Q203=0 Q204=3\nL X+1 FMAX M99"));
    expect_end(r, 1, 0, 10);
}

TEST(Klartext, Cycle201FeedsOut) {
    expect_same(
        "CYCL DEF 201 X Q200=2 Q201=-15 Q206=100 Q211=0.5 Q208=250 Q203=0 Q204=20\nL X+1 FMAX M99",
        "G0 X1.\nZ2.\nG1 Z-15. F100\nG4 P500\nG1 Z2. F250\nG0 Z20.");
}

TEST(Klartext, Cycle203BreaksChips) {
    const Made r =
        run(klartext("CYCL DEF 203 X Q200=2 Q201=-10 Q206=100 Q202=3 Q210=0 Q203=0 Q204=2 Q212=0.5 "
                     "Q213=1 Q205=1 Q211=0 Q208=MAX Q256=0.3\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    std::vector<double> heights;
    for (const Motion& m : r.moves)
        heights.push_back(end_of(m)->z.mm());
    // 3, 5.5, 7.5, 9, 10: each infeed is 0.5 shorter; after one break the tool retracts fully.
    const std::vector<double> expected{50,   50,   2,  -3, -2.7, -5.5, 2, -5.3,
                                       -7.5, -7.2, -9, 2,  -8.8, -10,  2};
    ASSERT_EQ(heights.size(), expected.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        EXPECT_NEAR(heights[i], expected[i], 1e-9) << i;
}

TEST(Klartext, Cycle205StartsDeeper) {
    const Made r =
        run(klartext("CYCL DEF 205 X Q200=2 Q201=-10 Q206=100 Q202=10 Q203=0 Q204=2 Q212=0 Q205=0 "
                     "Q258=0.5 Q259=1 Q257=3 Q256=0.2 Q211=0 Q379=4 Q253=750\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(end_of(r.moves[3])->z.mm(), -4.0, 1e-9);
    EXPECT_NEAR(r.moves[3].feed, 750.0, 1e-9);
    EXPECT_NEAR(end_of(r.moves[4])->z.mm(), -7.0, 1e-9);
}

TEST(Klartext, Cycle202OrientsTheSpindle) {
    const Made r =
        run(klartext("CYCL DEF 202 X Q200=2 Q201=-15 Q206=100 Q211=0.2 Q208=0 Q203=0 Q204=2 "
                     "Q214=1\nL X+1 FMAX M99\nL X+2 FMAX"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 6U);
    EXPECT_TRUE(r.moves[4].spindle_oriented);
    EXPECT_FALSE(r.moves[5].spindle_oriented);
}

TEST(Klartext, Cycle204BoresUpwards) {
    const Made r =
        run(klartext("CYCL DEF 204 X Q200=2 Q249=5 Q250=20 Q251=3 Q252=10 Q253=700 Q254=200 Q255=0 "
                     "Q203=0 Q204=50 Q214=1\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 8U);
    EXPECT_NEAR(end_of(r.moves[3])->z.mm(), -32.0, 1e-9);
    EXPECT_TRUE(r.moves[3].spindle_oriented);
    EXPECT_NEAR(end_of(r.moves[4])->z.mm(), -25.0, 1e-9);
}

TEST(Klartext, Cycle206And207Tap) {
    const Made r =
        run(klartext("CYCL DEF 207 X Q200=2 Q201=-10 Q239=+1.5 Q203=0 Q204=20\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 6U);
    EXPECT_DOUBLE_EQ(r.moves[3].feed, 1500.0);
    EXPECT_EQ(r.moves[3].spindle, SpindleTurning::Clockwise);
    EXPECT_EQ(r.moves[4].spindle, SpindleTurning::Counterclockwise);
    const Made left =
        run(klartext("CYCL DEF 207 X Q200=2 Q201=-10 Q239=-1.5 Q203=0 Q204=20\nL X+1 FMAX M99"));
    EXPECT_EQ(left.moves[3].spindle, SpindleTurning::Counterclockwise);
    expect_same("CYCL DEF 206 X Q200=2 Q201=-10 Q206=300 Q211=0 Q203=0 Q204=2\nL X+1 FMAX M99",
                "G0 X1.\nZ2.\nG1 Z-10. F300\nM4\nG1 Z2.\nM3");
}

TEST(Klartext, Cycle209BreaksChips) {
    const Made r = run(klartext(
        "CYCL DEF 209 X Q200=2 Q201=-10 Q239=1 Q203=0 Q204=2 Q257=4 Q256=0\nL X+1 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves.size(), 9U);
}

TEST(Klartext, Cycle208MillsAlongAHelix) {
    const Made r =
        run(klartext("CYCL DEF 208 X Q200=2 Q201=-10 Q206=300 Q334=3 Q203=0 Q204=20 Q335=30 Q342=0 "
                     "Q351=1\nL X+50 Y+20 FMAX M99"));
    expect_end(r, 50, 20, 20);
    const auto helix = std::ranges::count_if(r.moves, [](const Motion& m) {
        const auto* arc = std::get_if<Arc>(&m.what);
        return arc && arc->from.z != arc->to.z && arc->turns == 1 && arc->to.x.mm() == 60.0;
    });
    EXPECT_EQ(helix, 4);
}

TEST(Klartext, Cycle240ByDepth) {
    EXPECT_EQ(run(klartext("CYCL DEF 240 X Q200=2 Q343=0 Q201=-3 Q344=-10 Q206=100 Q211=0 Q203=0 "
                           "Q204=20\nL X+1 FMAX M99"))
                  .errors(),
              "");
    EXPECT_TRUE(
        run(klartext(
                "CYCL DEF 240 X Q200=2 Q343=1 Q201=-3 Q344=-10 Q206=100 Q203=0\nL X+1 FMAX M99"))
            .says("klartext-verb"));
}

TEST(Klartext, OldCyclesBeginAtTheClearance) {
    const Made r = run(
        klartext("CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SETUP 2\nCYCL DEF 1.2 DEPTH -3\nCYCL DEF 1.3 "
                 "PECKG +5\nCYCL DEF 1.4 DWELL\nCYCL DEF 1.5 F100\nL Z+12 FMAX\nL X+5 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(end_of(r.moves[3])->z.mm(), 7.0, 1e-9);
}

TEST(Klartext, ValuesAutoAndMaxInCycles) {
    const Made r =
        run("BEGIN PGM T MM\nTOOL CALL 1 Z S1000 F222\nL X+0 Y+0 Z+50 FMAX M3\nCYCL DEF 200 X "
            "Q200=2 Q201=-5 Q206=AUTO Q202=5 Q203=0\nCYCL CALL\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_DOUBLE_EQ(r.moves[2].feed, 222.0);
}

TEST(Klartext, FeedAfterACycleIsTheFeedBefore) {
    const Made r = run(klartext("L X+1 F77\n" + kDrill + "L X+10 FMAX M99\nL Z+60"));
    EXPECT_DOUBLE_EQ(r.moves.back().feed, 77.0);
}

TEST(Klartext, PocketsAreRefusedByName) {
    expect_refused("CYCL DEF 251 RECTANGULAR POCKET ~\n Q215=0",
                   "4:1: CYCL DEF 251 is not read; the program is stopped here [klartext-verb]");
    expect_refused("CYCL DEF 14.0 CONTOUR",
                   "4:1: CYCL DEF 14 is not read; the program is stopped here [klartext-verb]");
    expect_refused("TCH PROBE 400 BASIC ROTATION",
                   "4:1: TCH PROBE is not read; the program is stopped here [klartext-verb]");
    expect_refused("FL AN+45 LEN10",
                   "4:1: FL is not read; the program is stopped here [klartext-verb]");
    expect_refused("APPR LT X+1 Y+1 LEN5 RL",
                   "4:1: APPR is not read; the program is stopped here [klartext-verb]");
    expect_refused("FN 26: TABOPEN A.TAB",
                   "4:1: FN 26 is not read; the program is stopped here [klartext-verb]");
    expect_refused(
        "FUNCTION MODE TURN",
        "4:1: FUNCTION MODE TURN is not read; the program is stopped here [klartext-verb]");
}

TEST(Klartext, UnreachedBlocksAreNotRefused) {
    EXPECT_EQ(run("BEGIN PGM T MM\nL X+1 F100\nM30\nLBL 1\nTCH PROBE 400\nLBL 0\nEND PGM T MM\n")
                  .errors(),
              "");
}

// --- Transformations ---

TEST(Klartext, DatumShiftReplacesOnlyTheNamedAxes) {
    expect_same(
        "CYCL DEF 7.0 NULLPUNKT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+20\nL X+0 Y+0 F100\nCYCL DEF "
        "7.0\nCYCL DEF 7.1 IX+5\nL X+0 Y+0\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nL X+1 Y+1",
        "G52 X10. Y20.\nG1 X0. Y0. F100\nG52 X15. Y20.\nG1 X0. Y0.\nG52 X0. Y0.\nG1 X1. Y1.");
}

TEST(Klartext, DatumTableIsRefused) {
    EXPECT_TRUE(run(klartext("CYCL DEF 7.0\nCYCL DEF 7.1 #5")).says("klartext-verb"));
}

TEST(Klartext, PresetIsACoordinateSystem) {
    const Made r = run(
        "BEGIN PGM T MM\nCYCL DEF 247 X ~\nQ339=+2 ;NUMBER\nL X+1 Y+1 Z+1 F100\nEND PGM T MM\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.result.workpiece_system, 2);
    EXPECT_TRUE(run(klartext("CYCL DEF 247 X Q339=-1")).says("preset-unknown"));
}

TEST(Klartext, RotationAboutTheDatum) {
    expect_same(
        "CYCL DEF 10.0 DREHUNG\nCYCL DEF 10.1 ROT+30\nL X+10 Y+0 F100\nCC X+0 Y+0\nCP IPA+90 "
        "DR+\nCYCL DEF 10.1 IROT+15\nL X+10 Y+0\nCYCL DEF 10.1 ROT+0\nL X+1 Y+1",
        "G68 X0. Y0. R30.\nG1 X10. Y0. F100\nG3 X0. Y10. I-10. J0.\nG69\nG68 X0. Y0. R45.\nG1 X10. "
        "Y0.\nG69\nG1 X1. Y1.");
}

TEST(Klartext, MirrorImageSwapsArcsAndCompensation) {
    const Made r =
        run(klartext("CYCL DEF 8.0 SPIEGELN\nCYCL DEF 8.1 X\nL X+20 Y+0 F100\nL X+10 Y+0 RL\nL "
                     "X+10 Y+20\nL X+10 Y+40\nCYCL DEF 8.0"));
    EXPECT_EQ(r.errors(), "");
    // The path goes up at X-10; the tool, left of the programmed path at X5, is at X-5.
    EXPECT_NEAR(end_of(r.moves[3])->x.mm(), -5.0, 1e-9);
    const Made arc = run(klartext(
        "CYCL DEF 8.1 X\nL X+10 Y+0 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\nCYCL DEF 8.1\nL X+1"));
    EXPECT_EQ(arc.errors(), "");
    EXPECT_EQ(std::get<Arc>(arc.moves[2].what).turns, -1);
    EXPECT_NEAR(arc.end().x.mm(), 1.0, 1e-9);
}

TEST(Klartext, ScaleOfAllAxesAndByAxis) {
    expect_end(
        run(klartext("CYCL DEF 11.0 MASSFAKTOR\nCYCL DEF 11.1 SCL0.5\nL X+10 Y+20 Z+4 F100")), 5,
        10, 2);
    expect_end(run(klartext("CYCL DEF 26.0 X\nCYCL DEF 26.1 X2 Y0.5 CCX+1\nL X+10 Y+20 Z+4 F100")),
               19, 10, 4);
    EXPECT_TRUE(run(klartext("CYCL DEF 10.1 ROT+10\nCYCL DEF 8.1 X")).says("klartext-verb"));
}

TEST(Klartext, DwellOfCycle9) {
    expect_same("L X+1 F100\nCYCL DEF 9.0 V.ZEIT\nCYCL DEF 9.1 V.ZEIT 1,5\nL X+2",
                "G1 X1. F100\nG4 P1500\nX2.");
}

TEST(Klartext, ToleranceHasNoGeometry) {
    EXPECT_EQ(run(klartext("CYCL DEF 32.0 TOLERANZ\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 "
                           "TA0.5\nL X+1 F1"))
                  .errors(),
              "");
}

TEST(Klartext, PlaneNeedsAMachine) {
    EXPECT_EQ(
        run(klartext("PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY\nPLANE RESET STAY\nL X+1 F1")).errors(),
        "");
    EXPECT_TRUE(run(klartext("PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY")).says("kinematics"));
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
                                            "FR D6",
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
    KlartextLine line;
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
}  // namespace ncsim::gcode
