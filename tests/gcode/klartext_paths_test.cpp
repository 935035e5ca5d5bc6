// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls: arcs, corners, compensation, transformations. Where G-code has
// the same move, the motions of both programs are compared.
#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

namespace ncsim::gcode::klartext_test {
namespace {

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

TEST(Klartext, SignOfIpaAndDrMustBeEqual) {
    EXPECT_TRUE(run(klartext("L X+10 F100\nCC X+0 Y+0\nCP IPA+90 DR-")).says("direction-differs"));
}

TEST(Klartext, CircleByRadius) {
    expect_same("L X+10 Y+0 F100\nCR X+0 Y+10 R+10 DR+\nCR X+10 Y+0 R-10 DR+\nCR X+20 Y+0 R5 DR-",
                "G1 X10. Y0. F100\nG3 X0. Y10. R10.\nG3 X10. Y0. R-10.\nG2 X20. Y0. R5.");
}

TEST(Klartext, TangentialCircleNeedsAMoveBefore) {
    EXPECT_TRUE(run("BEGIN PGM T MM\nCT X+1 Y+1\nEND PGM T MM").says("tangent-missing"));
}

TEST(Klartext, PlaneOfTheToolAxis) {
    const Made y =
        run("BEGIN PGM T MM\nTOOL CALL 1 Y S1\nL X+0 Y+0 Z+10 FMAX\nCC X+0 Z+0\nC X+10 Z+0 DR+ "
            "F100\nEND PGM T MM\n");
    EXPECT_EQ(y.errors(), "");
    EXPECT_EQ(std::get<Arc>(y.moves.back().action).plane, Plane::ZX);
    const Made x =
        run("BEGIN PGM T MM\nTOOL CALL 1 X S1\nL X+0 Y+10 Z+0 FMAX\nCC Y+0 Z+0\nC Y+0 Z+10 DR+ "
            "F100\nEND PGM T MM\n");
    EXPECT_EQ(x.errors(), "");
    EXPECT_EQ(std::get<Arc>(x.moves.back().action).plane, Plane::YZ);
}

// --- Corners ---

TEST(Klartext, Rounding) {
    expect_same("L X+0 Y+0 F100\nL X+20\nRND R5\nL Y+20\nRND 2\nL X+0",
                "G1 X0. Y0. F100\nX20. ,R5.\nY20. ,R2.\nX0.");
}

TEST(Klartext, Chamfer) {
    expect_same("L X+0 Y+0 F100\nL X+20\nCHF 5\nL Y+20", "G1 X0. Y0. F100\nX20. ,C5.\nY20.");
}

TEST(Klartext, RoundingTooLargeForAnArc) {
    EXPECT_EQ(run(klartext("L X+20 F100\nRND R9\nCC X+10 Y+0\nC X+10 Y+10 DR+")).errors(),
              "5:1: RND needs elements that are long enough for it; the corner is left sharp "
              "[corner-form]\n");
}

TEST(Klartext, ChamferNextToAnArcIsRefused) {
    expect_refused(
        "L X+10 F100\nCHF 1\nCR X+0 Y+10 R10 DR+",
        "5:1: CHF next to an arc is not read; the program is stopped here [klartext-verb]");
    expect_refused("L X+10 F100\nRND 1\nTOOL CALL 2 Z",
                   "5:1: RND without a path block after it is not read; the program is stopped "
                   "here [klartext-verb]");
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

// --- Words that a block does not take -----------------------------------------------------------

/// Each verb with a complete block, and the words that it takes besides.
struct VerbWords {
    const char* block;
    const char* words;  // Separated by blanks.
};

/// A word that a verb does not take, and a word that stands twice, is refused with its place.
TEST(Klartext, WordsThatAVerbDoesNotTakeAreRefused) {
    const VerbWords verbs[] = {
        {"L Z+50", "X+1 Y+2 IX+1"},
        {"LP PR+10", "PA+20 IPA+20 Z+5"},
        {"C X+0 Y+20", "Z+5 DR+ DR-"},
        {"CP PA+90", "Z+5 DR+ DR-"},
        {"CR X+0 Y+20 R+20", "Z+5 DR+ DR-"},
        {"CT X+0 Y+20", "Z+5"},
        {"CTP PR+20", "PA+20 IPA+20 Z+5"},
        {"RND R2", ""},
        {"CHF 2", ""},
    };
    const std::string all[] = {"X+1", "Y+2", "IX+1", "PR+7", "IPR+7", "PA+20", "IPA+20",
                               "R+5", "DR+", "DR-",  "LEN5", "CCA90", "Z+5"};
    const std::string before = "L X+30 F100\nCC X+0 Y+0\nL X+20 Y+0\n";
    std::size_t refused = 0;
    for (const VerbWords& verb : verbs) {
        const std::string taken = " " + std::string(verb.words) + " ";
        for (const std::string& word : all) {
            const std::string block = std::string(verb.block) + " " + word;
            const Made made = run(klartext(before + block + "\nL Y+40\nL X+0"));
            if (taken.find(" " + word + " ") != std::string::npos) {
                EXPECT_FALSE(made.says("klartext-word")) << block << '\n' << made.errors();
                continue;
            }
            ++refused;
            EXPECT_TRUE(made.says("klartext-word")) << block << '\n' << made.errors();
            EXPECT_TRUE(made.result.refused || made.result.stopped) << block;
        }
    }
    EXPECT_GT(refused, 80U);
}

TEST(Klartext, WordsStandOnceInABlock) {
    for (const std::string block :
         {"L X+3 X+4", "L X+3 IX+4", "L X+3 RL R0", "L X+3 R0 R0", "LP PR+3 PA+3 PR+4",
          "CP PA+90 IPA+30 DR+", "C X+0 Y+20 DR+ DR-", "CR X+0 Y+20 R+20 R+30 DR+"}) {
        const Made made = run(klartext("CC X+0 Y+0\nL X+20 Y+0 F100\n" + block));
        EXPECT_TRUE(made.says("klartext-word")) << block << '\n' << made.errors();
    }
    // F of M128 is no feed of the path; several M codes are in order.
    for (const std::string block : {"L X+3 F100 M103 F20", "L X+3 FMAX M3 M8"})
        EXPECT_EQ(run(klartext(block)).errors(), "") << block;
    expect_refused("C X+0 Y+20 PA+90 DR+",
                   "4:12: 'PA+90' is no word of this block; the program is "
                   "stopped here [klartext-word]");
    expect_refused("CC X+0 Y+0\nLP X+10 PA+20",
                   "5:4: 'X' is no word of this block; the program is stopped here "
                   "[klartext-word]");
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
