// SPDX-License-Identifier: GPL-3.0-or-later
//
// The language of SINUMERIK controls: recognition, words, variables, tools, notes. Where G-code has
// the same move, the motions of both programs are compared.
#include "ncsim/gcode/sinumerik.h"

#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::gcode::sinumerik_test {
namespace {

// --- Recognition ---

TEST(Sinumerik, IsRecognisedByItsWords) {
    for (const std::string text :
         {"G0 SUPA Z0\nG1 X1 F100\nT=\"MILL\"\n", "DEF INT A\nG0 X1\n", "EXTERN CUT(REAL)\nG0 X1\n",
          "PROC CUT(REAL A)\nG1 X1 F1\n", "FOR R1=1 TO 3\nG0 X1\nENDFOR\n", "TRANS X10\nG0 X1\n",
          "ROT RPL=30\nG0 X1\n", "CYCLE81(5,0,2,-3)\nG0 X1\n", "G0 X1\nIF R1==1 GOTOF END\nEND:\n",
          "G710 G90\nG500\nG0 X1\n", "G2 X1 Y1 CR=5\n", "G3 I=AC(0) J=AC(5)\n",
          "TRAFOOF\nSTOPRE\nG0 X1\n", "%_N_PART_MPF\nG0 X1\n", "MSG(\"TEXT\")\nG0 X1\n",
          "G58 X10 Y0\nTRANS\nG0 X1\n"}) {
        EXPECT_TRUE(is_sinumerik({"part.nc", text})) << text;
        EXPECT_EQ(detect_dialect({"part.nc", text}).kind, Kind::Siemens) << text;
    }
}

TEST(Sinumerik, TheNameOfTheFileDecidesWithoutASign) {
    const SourceFile plain{"CUT.SPF", "G1 X10 F100\nG1 Y10\n"};
    EXPECT_TRUE(is_sinumerik(plain));
    EXPECT_FALSE(is_sinumerik({"cut.nc", plain.text}));
    EXPECT_FALSE(is_sinumerik({"cut.mpf", "G21 G90\nG43 H1 Z5\nG1 X10 F100\n"}));
}

TEST(Sinumerik, OtherLanguagesAreNotSinumerik) {
    for (const std::string text :
         {"#1=5\nWHILE[#1LT10]DO1\n#1=#1+1\nEND1\nG1 X#1 F100\n",
          "o100 repeat [3]\nG0 X1\no100 endrepeat\n", "(FOR X=1 TO 5)\nG21 G90\nG0 X1\n",
          "G0 X1\nIF[#1EQ1]GOTO10\nN10 G0 X2\n",
          "BEGIN PGM A MM\nL X+1 FMAX\nIF +Q1 EQU +1 GOTO LBL 1\nEND PGM A MM\n",
          "o1 if [#1 gt 2]\nG0 X1\no1 endif\n"})
        EXPECT_FALSE(is_sinumerik({"part.nc", text})) << text;
}

TEST(Sinumerik, RunsByItselfAndByTheChoiceOfTheUser) {
    const Made found =
        language_test::run(sinumerik("G1 X5 F100"), {}, Dialect::Auto, false, "a.mpf");
    EXPECT_EQ(found.errors(), "");
    EXPECT_EQ(found.result.dialect.dialect, Dialect::Sinumerik);
    EXPECT_TRUE(found.result.ended);
    EXPECT_EQ(run("G1 X1 F5\n").moves.size(), 1U);
}

TEST(Sinumerik, IsoModeIsReadAsFanuc) {
    const std::string text =
        "G291\nG21 G90 G17\nT1 M6\nG43 H1 Z5.\nG81 X1. Y1. Z-2. R1. F100\nG80\nM30\n";
    const Made r = run(text, {}, Dialect::SinumerikIso);
    EXPECT_EQ(r.errors(), "");
    EXPECT_GT(r.moves.size(), 3U);
    EXPECT_TRUE(run("G290\nG0 X1\n", {}, Dialect::SinumerikIso).says("language-switch"));
    EXPECT_EQ(run("G291\nG0 X1\n").errors(),
              "1:1: G291 is not read; the program is stopped here [not-read]\n");
}

// --- Blocks ---

TEST(Sinumerik, WordsWithoutBlanksNumbersAndComments) {
    expect_same("N10G1X10.5Y-.5F200;text\n:20 Z-1 ; (not (closed\nN30",
                "G1 X10.5 Y-0.5 F200\nZ-1.");
}

TEST(Sinumerik, NumbersWithoutAPointAreMillimetres) {
    expect_same("G1 X10 Y5 F100", "G1 X10. Y5. F100");
}

TEST(Sinumerik, ValuesBehindASign) {
    expect_same("R1=5 R2=2\nG1 X=R1+10 Y=-R2*R1 Z=(R1-3)/2 F=R1*20\nG=0 X=1.5EX1",
                "G1 X15. Y-10. Z1. F100\nG0 X15.");
}

TEST(Sinumerik, IncrementPerWordBeatsTheMode) {
    expect_same("G1 X10 Y10 F100\nX=IC(5) Y20\nG91 X5 Y=AC(3) Z=IC(-2)\nG90 X0",
                "G1 X10. Y10. F100\nX15. Y20.\nX20. Y3. Z48.\nX0.");
}

TEST(Sinumerik, IncrementsFromAnUnknownPlaceAreRelative) {
    const Made r = run("G91\nG1 X10 F100\nX10\nM30\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.moves.back().start_assumed);
}

TEST(Sinumerik, TwoWordsOfAGroup) {
    expect_refused("G0 G1 X1",
                   "5:4: G1 and another code of its group are in one block; the program is stopped "
                   "here [group-twice]");
}

TEST(Sinumerik, BlockDelete) {
    const std::string text = sinumerik("/G1 X10 F100\n/3 G1 Y5 F50\nN5 /G0 Z1");
    EXPECT_EQ(run(text).moves.size(), 4U);
    EXPECT_EQ(run(text, {}, Dialect::Sinumerik, true).moves.size(), 1U);
    EXPECT_TRUE(run(text).result.deletable.has_value());
}

TEST(Sinumerik, LineEndsEncodingsAndHiddenLinesChangeNothing) {
    const std::string text = sinumerik(
        ";*RO*\n; Fr\xE4ser\n; Fr\xC3\xA4ser\nMSG(\"Fr\xE4ser; gro\xDF\")\nG1 X10 F100 ;\x84\nG1 "
        "Y5");
    const Made a = run(text);
    std::string dos;
    for (const char c : text)
        dos += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(a.errors(), "");
    EXPECT_EQ(a.texts, run(dos).texts);
    EXPECT_EQ(a.texts, run("\xEF\xBB\xBF" + text + "\x1a").texts);
}

TEST(Sinumerik, BlockNumbersMayBeDropped) {
    const std::string plain =
        "R1=0\nAGAIN: R1=R1+1\nG1 X=R1 F100\nIF R1<3 GOTOB AGAIN\nG2 X5 Y2 CR=4";
    std::string numbered;
    int n = 10;
    for (std::size_t at = 0; at < plain.size();) {
        const std::size_t end = std::min(plain.find('\n', at), plain.size());
        numbered += "N" + std::to_string(n) + " " + plain.substr(at, end - at) + "\n";
        n += 10, at = end + 1;
    }
    expect_equal(plain, numbered);
}

TEST(Sinumerik, UnreadableText) {
    expect_refused("G1 X1 F1\n?&",
                   "6:1: '?&' is no block of SINUMERIK; the program is stopped here [not-read]");
    expect_refused("X (5)",
                   "5:1: 'X (5)' is no block of SINUMERIK; the program is stopped here [not-read]");
    expect_refused(
        "G81(5)", "5:1: 'G81(5)' is no block of SINUMERIK; the program is stopped here [not-read]");
    expect_refused(
        "(TEXT)", "5:1: '(TEXT)' is no block of SINUMERIK; the program is stopped here [not-read]");
}

// --- Modes ---

TEST(Sinumerik, UnitsOfLengthsAndFeeds) {
    const Made all = run("G700 G90\nT1 M6\nG0 X0 Y0 Z1\nG1 X1 F10\nM30\n");
    EXPECT_EQ(all.errors(), "");
    EXPECT_DOUBLE_EQ(all.end().x.mm(), 25.4);
    EXPECT_DOUBLE_EQ(all.moves.back().feed, 254.0);
    EXPECT_TRUE(all.result.units_stated);
    const Made lengths = run("G70 G90\nT1 M6\nG0 X0 Y0 Z1\nG1 X1 F254\nM30\n");
    EXPECT_DOUBLE_EQ(lengths.end().x.mm(), 25.4);
    EXPECT_NEAR(lengths.moves.back().feed, 254.0, 1e-9);
    EXPECT_TRUE(lengths.says("feed-unit"));
    EXPECT_FALSE(run("G0 X1\n").result.units_stated);
}

TEST(Sinumerik, DwellIsNoFeed) {
    expect_same("G1 X1 F100\nG4 F2.5\nX2\nS600\nG4 S30",
                "G1 X1. F100\nG4 X2.5\nX2.\nS600\nG4 X3.0");
}

TEST(Sinumerik, ConstantCuttingSpeedIsRefused) {
    expect_refused("G96 S100",
                   "5:1: constant cutting speed (G96) is not read; the program is stopped "
                   "here [not-read]");
}

TEST(Sinumerik, SettableOffsets) {
    const Made r = run("G710 G90\nT1 M6\nG505\nG0 X0 Y0 Z5\nG1 X5 F100\nG500 X0\nG54 X1\nM30\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.result.workpiece_system, 9 + 5);
    const Made last = run("G710 G90\nT1 M6\nG599\nG0 X0 Y0 Z5\nG1 X5 F100\nM30\n");
    EXPECT_EQ(last.errors(), "");
    EXPECT_EQ(last.result.workpiece_system, 9 + 99);
    for (const std::string code : {"G504", "G600"})
        expect_refused(code,
                       "5:1: " + code + " is not read; the program is stopped here [not-read]");
}

TEST(Sinumerik, ContourOffsetIsRefusedUnlessZero) {
    expect_equal("G41 OFFN=0\nG1 X20 F100\nY20\nG40 X0", "G41\nG1 X20 F100\nY20\nG40 X0");
    expect_refused("OFFN=0.5", "5:1: OFFN= is not read; the program is stopped here [not-read]");
}

TEST(Sinumerik, InvolutesAreRefused) {
    for (const std::string name : {"INVCW", "INVCCW"})
        expect_refused(name + " X10 Y5 CR=3",
                       "5:1: " + name + " is not read; the program is stopped here [not-read]");
}

TEST(Sinumerik, SwivelPlaneThatIsNotActiveMayBeCleared) {
    for (const std::string clear : {"CYCLE800()", "CYCLE800", "CYCLE800(1,\"0\",0,57)"}) {
        const Made r = run(sinumerik(clear + "\nG1 X5 F100"));
        EXPECT_EQ(r.errors(), "") << clear;
        EXPECT_FALSE(r.says("left-on")) << clear;
        EXPECT_EQ(r.texts, run(sinumerik("G1 X5 F100")).texts) << clear;
    }
}

TEST(Sinumerik, MachineCoordinatesForOneBlock) {
    expect_same("G0 SUPA Z0 D0\nG0 X5 D1\nG0 G53 X1\nX2\nG153 Y3",
                "G0 G53 Z0. G49\nG0 G43 H1 X5.\nG0 G53 X1.\nX2.\nG53 Y3.");
}

TEST(Sinumerik, LengthOfTheToolActsUnderSupa) {
    InterpreterOptions options;
    options.dialect = Dialect::Sinumerik;
    options.tools = {{.number = 1,
                      .offset = {Length(), Length(), Length::from_mm(30.0)},
                      .length_specified = true,
                      .diameter = {}}};
    options.work_offsets_specified[0] = true;
    std::vector<double> z;
    interpret({"a.mpf", "G710 G54 G90\nT1 M6\nG0 X0 Y0 Z5\nG0 SUPA Z50\nM30\n"}, options,
              [&](const Motion& motion) {
                  if (end_of(motion)) z.push_back(end_of(motion)->z.mm());
              });
    ASSERT_GE(z.size(), 2U);
    EXPECT_NEAR(z.back(), 50.0, 1e-9);  // The tip of the tool.
}

TEST(Sinumerik, ReferenceAndFixedPoints) {
    expect_same("G74 Z0\nG75 X0 Y5", "G91 G28 Z0.\nG28 X0. Y0.\nG90");
}

// --- Arcs ---

TEST(Sinumerik, ArcByRadius) {
    expect_same("G1 X0 Y0 F100\nG2 X10 Y0 CR=5\nG3 X0 Y0 CR=-6",
                "G1 X0. Y0. F100\nG2 X10. Y0. R5.\nG3 X0. Y0. R-6.");
}

TEST(Sinumerik, CentresAreRelativeUnlessAbsolute) {
    const Made r = run(sinumerik(
        "G1 X10 Y0 F100\nG3 X0 Y10 I-10 J0\nG2 X10 Y0 I=AC(0) J=AC(0)\nG3 I=AC(0) J=AC(0)"));
    expect_end(r, 10, 0, 50);
    const Made other = run(sinumerik("G1 X10 Y0 F100\nG3 X0 Y10 CR=10\nG2 X10 Y0 CR=10\nG3 I-10"));
    ASSERT_EQ(r.moves.size(), other.moves.size());
    expect_end(other, 10, 0, 50);
}

TEST(Sinumerik, OpeningAngle) {
    const Made by_end = run(sinumerik("G1 X10 Y0 F100\nG3 X0 Y10 AR=90"));
    expect_end(by_end, 0, 10, 50);
    const Made by_centre = run(sinumerik("G1 X10 Y0 F100\nG3 I-10 J0 AR=90"));
    expect_end(by_centre, 0, 10, 50);
}

TEST(Sinumerik, IntermediatePoint) {
    const Made r =
        run(sinumerik("G1 X10 Y0 F100\nCIP X-10 Y0 I1=0 J1=10\nG91 CIP X20 Y0 I1=10 J1=-10"));
    expect_end(r, 10, 0, 50);
    const Made full = run(sinumerik("G1 X10 Y0 F100\nG3 X-10 Y0 I-10\nG3 X10 Y0 I10"));
    ASSERT_EQ(r.moves.size(), full.moves.size());
    expect_refused(
        "G1 X1 F1\nCIP X2 Y0 Z5 I1=1 J1=1 K1=2",
        "6:1: CIP outside the plane is not read; the program is stopped here [not-read]");
}

TEST(Sinumerik, IntermediatePointFollowsTheDistanceMode) {
    expect_equal("G1 X10 Y0 F100\nG91 CIP X-10 Y10 I1=-2.928932188 J1=7.071067812",
                 "G1 X10 Y0 F100\nCIP X0 Y10 I1=7.071067812 J1=7.071067812");
}

TEST(Sinumerik, TangentialArc) {
    const Made r = run(sinumerik("G1 X10 Y0 F100\nCT X20 Y10"));
    expect_end(r, 20, 10, 50);
    expect_equal("G1 X10 Y0 F100\nG3 X20 Y10 I=AC(10) J=AC(10)\nG1 X0",
                 "G1 X10 Y0 F100\nCT X20 Y10\nG1 X0");
}

TEST(Sinumerik, TurnsAreExtra) {
    expect_same("G1 X10 Y0 F100\nG3 X10 Y0 Z40 I=AC(0) J=AC(0) TURN=2",
                "G1 X10. Y0. F100\nG3 X10. Y0. Z40. I-10. J0. P3");
}

TEST(Sinumerik, ArcWithoutCentre) {
    expect_refused(
        "G1 X1 F1\nG2 X5 Y5",
        "6:1: G2 needs a centre (I, J, K), CR or AR; the program is stopped here [word-missing]");
}

TEST(Sinumerik, PolarCoordinates) {
    expect_same("G111 X10 Y10\nG1 AP=90 RP=5 F100\nG1 AP=180\nG110 X1 Y0\nG0 RP=2 AP=0",
                "G1 X10. Y15. F100\nG1 X5. Y10.\nG0 X8. Y10.");
}

TEST(Sinumerik, PoleFromTheLastPole) {
    expect_same("G111 X10 Y10\nG112 X5 Y1\nG1 AP=0 RP=4 F100", "G1 X19. Y11. F100");
}

TEST(Sinumerik, PositionsOfTheProgramAndTheMachine) {
    const Made r = run(sinumerik("G0 X3 Y4\nG0 X=$P_EP[X]*2 Y=$AA_IW[Y]+1"));
    expect_end(r, 6, 5, 50);
}

TEST(Sinumerik, RoundingAndChamfer) {
    expect_same("G1 X10 F100 RND=2\nY10\nG1 X20 CHR=1\nY20",
                "G1 X10. F100 ,R2.\nY10.\nG1 X20. ,C1.\nY20.");
}

TEST(Sinumerik, ChamferByItsLength) {
    // The chamfer of a right angle is sqrt(2) times its legs.
    expect_close("G1 X10 F100 CHF=2.8284271247\nY10", "G1 X10. F100 ,C2.\nY10.");
    // Lines at 60 degrees: the chamfer is as long as its legs.
    expect_close("G1 X10 F100 CHF=2\nX5 Y8.660254038", "G1 X10. F100 ,C2.\nX5. Y8.660254038");
}

TEST(Sinumerik, RoundingIsModal) {
    expect_same("G1 X10 F100 RNDM=2\nY10\nX0\nG0 Z60\nG1 Z50\nG1 X10 RND=3\nY0\nX0 RNDM=0\nY-5",
                "G1 X10. F100 ,R2.\nY10. ,R2.\nX0.\nG0 Z60.\nG1 Z50.\nG1 X10. ,R3.\n"
                "Y0. ,R2.\nX0.\nY-5.");
}

TEST(Sinumerik, RoundingAtArcs) {
    expect_close("G1 X20 F100 RND=2\nG3 X10 Y10 I-10 J0",
                 "G1 X17.745966692 F100\nG3 X19.682458366 Y2.5 I0. J2.\n"
                 "G3 X10. Y10. I-9.682458366 J-2.5");
    expect_close("G1 X10 Y10 F100\nG2 X20 Y0 I0 J-10 RND=2\nG1 X0",
                 "G1 X10. Y10. F100\nG2 X19.682458366 Y2.5 I0. J-10.\n"
                 "G2 X17.745966692 Y0. I-1.936491673 J-0.5\nG1 X0.");
    expect_refused("G1 X10 F100\nG2 X20 Y0 I0 J-10 CHR=2",
                   "6:19: a chamfer at an arc (CHR, CHF, ANG) is not read; the program is stopped "
                   "here [not-read]");
}

TEST(Sinumerik, BlocksWithoutAMoveInACorner) {
    expect_close("G1 X10 F100 RND=2\nF50\nM8\nY10", "G1 X10. F100 ,R2.\nY10. F50");
    expect_close("G1 X10 F100 RNDM=2\nM8\nY10 RNDM=0", "G1 X10. F100 ,R2.\nY10.");
    // A rapid move, a stop and a dwell end the contour.
    expect_close("G1 X10 F100 RNDM=2\nG4 F1\nG1 Y10 RNDM=0", "G1 X10. F100\nG4 P1000\nY10.");
}

TEST(Sinumerik, FeedOfACorner) {
    const Made r = run(sinumerik("FRCM=30\nG1 X10 F100 RND=2 FRC=50\nY10 RND=2\nX0 FRCM=0"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 6U);
    EXPECT_NE(r.texts[2].find("F50"), std::string::npos) << r.texts[2];
    EXPECT_NE(r.texts[3].find("F100"), std::string::npos) << r.texts[3];
    EXPECT_NE(r.texts[4].find("F30"), std::string::npos) << r.texts[4];
}

TEST(Sinumerik, LineByItsAngle) {
    expect_same("G1 X10 F100\nX20 ANG=45\nY0", "G1 X10. F100\nX20. ,A45.\nY0.");
}

// --- Cutter compensation ---

TEST(Sinumerik, CompensationWithTheRadiusOfD) {
    expect_same("G0 X-20 Y-20 Z-5\nG41 G1 X0 Y-20 F100\nY20\nX30\nG40 G0 Y50",
                "G0 X-20. Y-20. Z-5.\nG41 D1 G1 X0. Y-20. F100\nY20.\nX30.\nG40 G0 Y50.");
}

TEST(Sinumerik, CompensationWithoutAToolRadius) {
    expect_equal("D0\nG0 X-20 Y-20\nG42 G1 X0 Y-20 F100\nY20\nG40 G0 Y50",
                 "D0\nG0 X-20 Y-20\nG1 X0 Y-20 F100\nY20\nG0 Y50");
}

TEST(Sinumerik, CornersByIntersectionAreRefused) {
    expect_refused("G451\nG41 G1 X5 F100",
                   "6:1: G41 or G42 with G451 is not read; the program is stopped here [not-read]");
    expect_refused("KONT", "5:1: KONT is not read; the program is stopped here [not-read]");
    expect_refused("G147", "5:1: G147 is not read; the program is stopped here [not-read]");
}

// --- Tools ---

TEST(Sinumerik, ToolsWithM6) {
    const Made r = run(sinumerik("T2\nG1 X1 F1\nM6\nG1 X2\nT3 M6\nT0 M6"));
    EXPECT_EQ(r.errors(), "");
    expect_same("T2\nG1 X1 F1\nM6\nG0 X2", "T2\nG1 X1. F1\nM6\nG43 H2\nG0 X2.");
}

TEST(Sinumerik, ToolWordChangesWithoutM6) {
    const Made r = run("G710 G90\nT1\nG0 X0 Y0 Z5\nT2 D1\nG1 X1 F1\nM30\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("tool-change"));
}

TEST(Sinumerik, ToolsByName) {
    const Made r = run("G710 G90\nT=\"SCHAFT_D8\" M6\nG0 X0 Y0 Z5\nT=\"DRILL\"\nM6\nG0 X1\nM30\n");
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("tool-name"));
}

TEST(Sinumerik, OtherEdgesAreADoubt) {
    EXPECT_TRUE(run(sinumerik("D2\nG1 X1 F1")).says("tool-edge"));
    EXPECT_FALSE(run(sinumerik("D1\nG1 X1 F1")).says("tool-edge"));
}

TEST(Sinumerik, AToolNamedByItsNumberHasTheNumber) {
    for (const std::string tool : {"T=\"12\"", "T12", "T=12", "T=\"0012\""})
        EXPECT_EQ(run("G710 G90\n" + tool + " M6\nG0 X1 Y1 Z1\nM30\n").moves.back().tool, 12)
            << tool;
    for (const std::string tool : {"T=\"12A\"", "T=\"9001\"", "T=\"12.5\"", "T=\"0\""})
        EXPECT_EQ(run("G710 G90\n" + tool + " M6\nG0 X1 Y1 Z1\nM30\n").moves.back().tool, 9001)
            << tool;
}

TEST(Sinumerik, RadiusOfTheTool) {
    expect_same("R1=$P_TOOLR\nG1 X=R1 F100", "G1 X5. F100");
    expect_refused("R1=$AC_TIMER[1]",
                   "5:4: $AC_TIMER is data of the control, which are not known here; the "
                   "program is stopped here [variable-missing]");
    expect_refused(
        "$TC_DP6[1,1]=5",
        "5:1: an assignment to $TC_DP6 is not read; the program is stopped here [not-read]");
}

// --- Rotary axes ---

TEST(Sinumerik, WaysOfRotaryAxes) {
    const Made r = run(sinumerik("G0 C350\nC=DC(10)\nC=ACP(5)\nC=ACN(4)\nC=IC(-4)"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 6U);
    const auto c = [&](std::size_t i) { return end_of(r.moves[i])->c.degrees(); };
    EXPECT_DOUBLE_EQ(c(1), 350.0);
    EXPECT_DOUBLE_EQ(c(2), 370.0);
    EXPECT_DOUBLE_EQ(c(3), 725.0);
    EXPECT_DOUBLE_EQ(c(4), 724.0);
    EXPECT_DOUBLE_EQ(c(5), 720.0);
}

// --- Words without path, and refused words ---

TEST(Sinumerik, WordsWithoutPathArePassed) {
    expect_same(
        "FNORM CFTCP FFWON SOFT STOPRE G60 G601 CUT2D COMPOF\nG64 G1 X5 F100\nCYCLE832(0.01,1,1)\n"
        "MSG(\"A;B\")\nSETMS(1)\nDIAMOF NORM\nACC[X]=50 OVR=100\nH5=3\nG1 Y5",
        "G1 X5. F100\nG1 Y5.");
}

TEST(Sinumerik, ConstructsAreRefusedByName) {
    for (const std::string name :
         {"ASPLINE", "BSPLINE", "CSPLINE", "POLY", "TRANSMIT", "TOROT", "RTLIOF", "DIAMON",
          "CUT3DC", "WHEN", "SETINT", "G33", "G34", "G81", "G331"})
        expect_refused(name,
                       "5:1: " + name + " is not read; the program is stopped here [not-read]");
    for (const std::string name :
         {"CYCLE70", "CYCLE73", "CYCLE74", "CYCLE75", "CYCLE79", "CYCLE95", "CYCLE930", "TRACYL"})
        expect_refused(name + "(1,2)",
                       "5:1: " + name + " is not read; the program is stopped here [not-read]");
    expect_refused("WHENEVER $A_IN[1] DO M5",
                   "5:1: WHENEVER is not read; the program is stopped here [not-read]");
}

TEST(Sinumerik, UnknownMCodesAreReported) {
    EXPECT_TRUE(run(sinumerik("M81")).says("unknown-m"));
    EXPECT_FALSE(run(sinumerik("M41")).says("unknown-m"));
}

// --- Notes ---

TEST(Sinumerik, WorkpieceIsTheStock) {
    const SourceFile file{
        "a.mpf",
        "G710\nWORKPIECE(,\"\",,\"BOX\",112,0,-23,,92,59,-92,-59)\nT=\"SCHAFT_D8\"\n"
        "G0 X=R1 Y5\nG0 SUPA Z0\n; T2 D=8 - flat end mill\n"};
    SinumerikNotes notes(file);
    Block block;
    std::vector<std::string> comments;
    std::string words;
    while (notes.next(block)) {
        for (const Comment& comment : block.comments)
            comments.emplace_back(comment.text);
        for (const Word& word : block.words)
            words += word.letter;
    }
    EXPECT_EQ(comments, (std::vector<std::string>{"BLK FORM 0.1 Z X-92 Y-59 Z-23",
                                                  "BLK FORM 0.2 X+92 Y+59 Z+0", "T9001 SCHAFT D8",
                                                  " T2 D=8 - flat end mill"}));
    EXPECT_EQ(words, "GTGXYGGZ");
}

TEST(Sinumerik, WorkpieceWithLengths) {
    const SourceFile file{"a.mpf", "WORKPIECE(,,,\"BOX\",0,0,-50,-80,10,20,100,50)\n"};
    SinumerikNotes notes(file);
    Block block;
    ASSERT_TRUE(notes.next(block));
    ASSERT_EQ(block.comments.size(), 2U);
    EXPECT_EQ(block.comments[0].text, "BLK FORM 0.1 Z X+10 Y+20 Z-50");
    EXPECT_EQ(block.comments[1].text, "BLK FORM 0.2 X+110 Y+70 Z+0");
}

TEST(Sinumerik, RoundWorkpiece) {
    const auto found =
        sinumerik_cylinder({"a.mpf", "WORKPIECE(,,,\"CYLINDER\",64,0,-40,-80,60)\n"});
    ASSERT_TRUE(found.has_value());
    EXPECT_DOUBLE_EQ(found->radius.mm(), 30.0);
    EXPECT_DOUBLE_EQ(found->length.mm(), 40.0);
    EXPECT_DOUBLE_EQ(found->top.mm(), 0.0);
}

TEST(Sinumerik, Listing) {
    const SourceFile file{"a.mpf", "N10 START:  G1   X10 ; text\n; only\nSTOPRE\n"};
    SinumerikListing listing(file);
    DiagnosticLog log;
    ListedBlock line;
    std::vector<std::string> texts;
    while (listing.next(line, log))
        texts.push_back(line.text);
    EXPECT_EQ(texts, (std::vector<std::string>{"START: G1 X10", "STOPRE"}));
}

/// A word that the block does not use, and a word that stands twice, is reported.
TEST(Sinumerik, WordsThatABlockDoesNotUseAreReported) {
    const std::string head = "G17 G90 G71 G54 F100 S100 M3\nG0 X5 Y5 Z0\n";
    const auto says = [&](const std::string& block, const std::string& code) {
        return run(head + block + "\nM30\n").says(code);
    };
    for (const std::string word : {"CR=20", "AR=90", "TURN=2", "I5", "J=AC(5)", "K3", "I1=3"}) {
        EXPECT_TRUE(says("G0 X1 " + word, "word-unused")) << word;
        EXPECT_TRUE(says("G1 X1 Z-1 " + word, "word-unused")) << word;
    }
    for (const std::string block :
         {"G3 X5 Y-5 I-5 J-5 CR=7.0711", "G3 X5 Y-5 CR=7.0711 AR=90", "G3 X5 Y-5 I-5 J-5 K3",
          "G3 X5 Y-5 CR=8 I1=3", "G3 X5 Y-5 I-5 J-5 AR=90", "CIP X5 Y-5 I1=-5 J1=0 CR=3"}) {
        EXPECT_TRUE(says(block, "word-unused")) << block;
    }
    for (const std::string block : {"G3 X5 Y-5 I-5 J-5", "G3 X5 Y-5 CR=8 TURN=1", "G1 X1 RND=0",
                                    "G3 AR=90 I-5 J-5", "G3 X5 Y-5 AR=90", "G2 X5 Y-5 I-5 J-5 K0",
                                    "CIP X5 Y-5 I1=-5 J1=0", "G1 X1 Y1 Z1 F3 S3 M4 H5"}) {
        EXPECT_FALSE(says(block, "word-unused")) << block;
        EXPECT_FALSE(says(block, "word-twice")) << block;
    }
    for (const std::string block : {"G1 X1 X2", "G1 X1 X=IC(3)", "G3 X5 Y-5 CR=8 CR=9",
                                    "G3 X5 Y-5 I-5 J-5 I=AC(0)", "G1 X1 F100 F200"}) {
        EXPECT_TRUE(says(block, "word-twice")) << block;
    }
}

}  // namespace
}  // namespace ncsim::gcode::sinumerik_test
