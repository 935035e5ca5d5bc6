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

}  // namespace
}  // namespace ncsim::gcode::klartext_test
