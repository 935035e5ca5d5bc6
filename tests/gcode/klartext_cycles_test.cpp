// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls: tools, M codes, cycles. Where G-code has the same
// move, the motions of both programs are compared. Heights of hole cycles are in
// tests/programs/klartext-*.
#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ncsim::gcode::klartext_test {
namespace {

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

TEST(Klartext, AToolNamedByItsNumberHasTheNumber) {
    EXPECT_EQ(run(klartext("TOOL CALL \"12\" Z S9\nL X+1 FMAX")).moves.back().tool, 12);
}

TEST(Klartext, ToolCallByParameter) {
    for (const char* call : {"Q1 = 7\nTOOL CALL Q1 Z S9", "TOOL CALL 7 Z S9"})
        EXPECT_EQ(run(klartext(std::string(call) + "\nL X+1 FMAX")).moves.back().tool, 7);
    const Made named = run(klartext("QS1 = \"FR_D10\"\nTOOL CALL QS1 Z S9\nL X+1 FMAX"));
    EXPECT_EQ(named.errors(), "");
    EXPECT_EQ(named.moves.back().tool, 9001);
    expect_refused("TOOL CALL 5.1 Z S9",
                   "4:11: a step of a tool (T.1) is not read; the program is stopped here "
                   "[klartext-verb]");
}

TEST(Klartext, ToolCallOfZeroUnloads) {
    const Made r = run(klartext("TOOL CALL 0\nL X+1 FMAX"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_EQ(r.moves.back().tool, 0);
    EXPECT_EQ(r.moves.back().length, Length());
}

TEST(Klartext, OversizeWithADigitIsOfTheCornerRadius) {
    // DR2 is no oversize of the radius; DR+ without a digit is a direction.
    const std::string path = "\nL X+10 RL F100\nL X+20\nL X+30";
    const Made corner = run(klartext("TOOL CALL 1 Z S9 DR2+0.5" + path));
    const Made radius = run(klartext("TOOL CALL 1 Z S9 DR+0.5" + path));
    EXPECT_NEAR(end_of(corner.moves[1])->y.mm(), 5.0, 1e-9);
    EXPECT_NEAR(end_of(radius.moves[1])->y.mm(), 5.5, 1e-9);
}

TEST(Klartext, DataOfTheToolInQ108AndQ109) {
    const Made r = run(klartext("TOOL CALL 1 Y S9\nL X+Q108 Z+Q109 FMAX"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_NEAR(r.end().x.mm(), 5.0, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), 1.0, 1e-9);
}

TEST(Klartext, OversizeOfTheLengthIsRefused) {
    for (const std::string length : {"DL+0.1", "DL-0.1", "DL+Q1"}) {
        const Made r =
            run("BEGIN PGM T MM\nQ1 = 2\nTOOL CALL 1 Z S1 " + length + "\nEND PGM T MM\n");
        EXPECT_TRUE(r.says("klartext-verb")) << length;
        EXPECT_TRUE(r.result.refused) << length;
    }
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

TEST(Klartext, BlockWithoutAxesCallsTheCycle) {
    const std::string cycle =
        "CYCL DEF 200 A Q200=2 Q201=-10 Q206=100 Q202=10 Q203=0 Q204=5\nL X+3 FMAX";
    EXPECT_EQ(run(klartext(cycle + "\nL FMAX M99")).texts, run(klartext(cycle + " M99")).texts);
}

TEST(Klartext, CyclesOfTheMachineBuilderWithoutGeometry) {
    for (const char* number : {"32.0", "239", "332", "392"}) {
        const Made r = run(klartext(std::string("CYCL DEF ") + number + " TOLERANCE\nL X+1 FMAX"));
        expect_end(r, 1, 0, 50);
        EXPECT_EQ(r.moves.size(), 2U);
    }
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

TEST(KlartextCycles, CallPosWithTheToolAxisShiftsTheSurface) {
    // "Z-5" shifts the surface of the cycle, for this call only.
    const Made r = run(klartext(kDrill + "CYCL CALL POS X+10 Y+5 Z-5 FMAX\nL X+20 FMAX M99"));
    const Made plain = run(klartext(kDrill + "L X+10 Y+5 FMAX M99\nL X+20 FMAX M99"));
    EXPECT_EQ(r.errors(), "");
    const auto lowest = [](const Made& made, double x) {
        double z = 1e9;
        for (const Motion& move : made.moves) {
            if (end_of(move)->x.mm() == x) z = std::min(z, end_of(move)->z.mm());
        }
        return z;
    };
    EXPECT_EQ(lowest(r, 10.0), lowest(plain, 10.0) - 5.0);
    EXPECT_EQ(lowest(r, 20.0), lowest(plain, 20.0));
    expect_refused(kDrill + "CYCL CALL POS X+10 Y+5 IZ-5 FMAX",
                   std::to_string(5 + std::ranges::count(kDrill, '\n') - 1) +
                       ":1: CYCL CALL POS with an increment of the tool axis is not read; the "
                       "program is stopped here [klartext-verb]");
}

TEST(KlartextCycles, PatternsRefused) {
    expect_refused("CYCL DEF 220 Q216=0 Q217=0 Q244=40",
                   "4:1: cycle 220 needs Q241; the program is stopped here [cycle-parameter]");
    expect_refused(kDrill + "CYCL DEF 221 Q225=0 Q226=0 Q237=10 Q238=20 Q242=0 Q243=2",
                   "13:1: cycle 221 needs a number of places from 1 to 10000; the program is "
                   "stopped here [word-missing]");
    expect_refused(kDrill + "CYCL DEF 220 Q216=0 Q217=0 Q244=40 Q241=4 Q365=1",
                   "13:1: cycle 220 with arcs between (Q365=1) is not read; the program is stopped "
                   "here [klartext-verb]");
    EXPECT_TRUE(run(klartext("CYCL DEF 220 Q216=0 Q217=0 Q244=40 Q241=4")).says("cycle-undefined"));
}

TEST(KlartextCycles, CallPosBelowTheSurfaceGoesUpFirst) {
    const Made r = run(klartext(kDrill + "L Z-20 FMAX\nCYCL CALL POS X+10 Y+5 Z+0 FMAX"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_GT(r.moves.size(), 3U);
    EXPECT_EQ(end_of(r.moves[2])->x.mm(), 0.0);
    EXPECT_GT(end_of(r.moves[2])->z.mm(), 0.0);
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

TEST(Klartext, ConstructsAreRefusedByName) {
    for (const std::string number : {"21", "27", "28", "266", "270", "271"})
        expect_refused("CYCL DEF " + number + " NAME ~\n Q215=0",
                       "4:1: CYCL DEF " + number +
                           " is not read; the program is stopped here [klartext-verb]");
    expect_refused("CYCL DEF 21 PILOT DRILLING",
                   "4:1: CYCL DEF 21 is not read; the program is stopped here [klartext-verb]");
    expect_refused("TCH PROBE 400 BASIC ROTATION",
                   "4:1: TCH PROBE is not read; the program is stopped here [klartext-verb]");
    expect_refused("FL AN+45 LEN10",
                   "4:1: FL is not read; the program is stopped here [klartext-verb]");
    expect_refused("APPR X+1 Y+1 LEN5 RL",
                   "4:1: APPR is not read; the program is stopped here [klartext-verb]");
    expect_refused("LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+1 F100",
                   "4:1: LN is not read; the program is stopped here [klartext-verb]");
    expect_refused("FN 26: TABOPEN A.TAB",
                   "4:1: FN 26 is not read; the program is stopped here [klartext-verb]");
    expect_refused(
        "FUNCTION MODE TURN",
        "4:1: FUNCTION MODE TURN is not read; the program is stopped here [klartext-verb]");
}

TEST(Klartext, ProbingOfTheToolIsLeftOut) {
    for (const char* number : {"30", "481", "584"}) {
        const Made r = run(klartext(std::string("TCH PROBE ") + number +
                                    " TOOL LENGTH ~\n Q340=+1 ~\n Q260=+100\nL X+1 FMAX"));
        expect_end(r, 1, 0, 50);
        EXPECT_TRUE(r.says("tool-probe"));
    }
}

TEST(Klartext, UnreachedBlocksAreNotRefused) {
    EXPECT_EQ(run("BEGIN PGM T MM\nL X+1 F100\nM30\nLBL 1\nTCH PROBE 400\nLBL 0\nEND PGM T MM\n")
                  .errors(),
              "");
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
