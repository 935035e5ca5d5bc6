// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames of SINUMERIK: TRANS, ROT, SCALE, MIRROR, G58, G59, CYCLE800, TRAORI.
#include "gcode/cradle.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace ncsim::gcode::sinumerik_test {
namespace {

/// End of the program in coordinates of the part.
Made made(const std::string& blocks) {
    return run(sinumerik(blocks));
}
void expect_place(const std::string& blocks, double x, double y, double z) {
    expect_end(made(blocks), x, y, z);
}

TEST(SinumerikFrames, TranslationReplacesAndAdds) {
    expect_place("TRANS X10 Y20\nG0 X1 Y2 Z3", 11, 22, 3);
    expect_place("TRANS X10\nATRANS X5 Y1\nG0 X1 Y2 Z3", 16, 3, 3);
    expect_place("TRANS X10\nTRANS Y5\nG0 X1 Y2 Z3", 1, 7, 3);
    expect_place("TRANS X10\nTRANS\nG0 X1 Y2 Z3", 1, 2, 3);
}

TEST(SinumerikFrames, TranslationIsTheSameAsAnOffset) {
    expect_equal("TRANS X10 Y-5 Z2\nG1 X1 Y1 Z0 F100\nG2 X11 Y11 CR=10\nG0 Z5",
                 "G1 X11 Y-4 Z2 F100\nG2 X21 Y6 CR=10\nG0 Z7");
}

TEST(SinumerikFrames, RotationInThePlane) {
    expect_place("ROT Z90\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_place("ROT RPL=90\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_place("TRANS X5\nAROT RPL=90\nG0 X10 Y0 Z1", 5, 10, 1);
    expect_place("ROT RPL=90\nATRANS X5\nG0 X10 Y0 Z1", 0, 15, 1);
    expect_place("ROT RPL=30\nAROT RPL=60\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_place("ROT RPL=90\nROT\nG0 X10 Y0 Z1", 10, 0, 1);
}

TEST(SinumerikFrames, AnyProgrammableFrameReplacesAllOthers) {
    expect_place("TRANS X10\nROT RPL=90\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_place("ROT RPL=90\nSCALE X2\nG0 X10 Y0 Z1", 20, 0, 1);
    expect_place("SCALE X2\nMIRROR X0\nG0 X10 Y0 Z1", -10, 0, 1);
}

TEST(SinumerikFrames, ScaleAndMirror) {
    expect_place("SCALE X2 Y2 Z2\nG0 X1 Y2 Z3", 2, 4, 6);
    expect_place("TRANS X10\nASCALE X2\nATRANS X1\nG0 X1 Y0 Z0", 14, 0, 0);
    expect_place("MIRROR X0\nG0 X1 Y2 Z3", -1, 2, 3);
    expect_place("TRANS X10\nAMIRROR X0\nG0 X1 Y2 Z3", 9, 2, 3);
    expect_place("MIRROR X0\nAROT RPL=90\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_place("MIRROR X0\nAROT RPL=90\nG0 X0 Y10 Z1", 10, 0, 1);
    expect_refused("SCALE X2\nAROT RPL=30",
                   "6:1: a rotation behind a scale by axis is not read; the program is "
                   "stopped here [not-read]");
}

TEST(SinumerikFrames, MirrorTurnsArcsAndTheSideOfTheTool) {
    expect_equal(
        "MIRROR X0\nG0 X-20 Y-20 Z0\nG41 G1 X0 Y-20 F100\nY20\nG2 X10 Y30 CR=10\nG40 G0 Y50",
        "G0 X20 Y-20 Z0\nG42 G1 X0 Y-20 F100\nY20\nG3 X-10 Y30 CR=10\nG40 G0 Y50");
}

TEST(SinumerikFrames, NeedABlockOfTheirOwn) {
    expect_refused(
        "TRANS X10 F100",
        "5:1: TRANS needs a block of its own; the program is stopped here [frame-own-block]");
    expect_refused(
        "G41\nTRANS X10",
        "6:1: a frame under G41 or G42 is not read; the program is stopped here [not-read]");
}

TEST(SinumerikFrames, CoarseAndFinePart) {
    expect_place("TRANS X10 Y10 Z10\nATRANS X5 Y5\nG0 X0 Y0 Z0", 15, 15, 10);
    expect_place("TRANS X10 Y10 Z10\nATRANS X5 Y5\nG58 X20\nG0 X0 Y0 Z0", 25, 15, 10);
    expect_place("TRANS X10 Y10 Z10\nATRANS X5 Y5\nG58 X20\nG59 X10 Y10\nG0 X0 Y0 Z0", 30, 20, 10);
    expect_refused("TRANS X10\nATRANS X5\nTRANS X3",
                   "7:1: TRANS after ATRANS or G59 may keep or delete their part of the offset; "
                   "write TRANS alone "
                   "before it; the program is stopped here [reading-guess]");
    expect_refused("ROT RPL=30\nG58 X5",
                   "6:1: G58 behind a rotation, a scale or a mirror image is not read; the "
                   "program is stopped here [not-read]");
}

TEST(SinumerikFrames, FramesStayAcrossASettableOffset) {
    const Made r = run("G710 G90 G54\nT1 M6\nG0 X0 Y0 Z0\nTRANS X10\nG0 X1 Y0 Z0\nM30\n");
    expect_end(r, 11, 0, 0);
}

TEST(SinumerikFrames, SupaSuppressesFrames) {
    expect_same("TRANS X10\nG0 SUPA X5\nG0 X1", "G0 G53 X5.\nG0 X11.");
}

TEST(SinumerikFrames, FrameOfASubprogramWithSave) {
    const Files files{{"CUT.SPF", "PROC CUT SAVE\nTRANS X10\nG91 G1 X1 F100\nM17\n"}};
    const Made r = run(sinumerik("G1 X0 F100\nCUT\nX2"), files);
    expect_end(r, 2, 0, 50);
}

TEST(SinumerikFrames, ShiftOfTheSwivelPlaneNeedsNoMachine) {
    expect_place("CYCLE800(2,\"TISCH\",200000,57,0,0,50,0,0,0,0,0,0,1,,1)\nG0 X1 Y2 Z3", 1, 2, 53);
    expect_place(
        "CYCLE800(2,\"TISCH\",200000,57,1,0,0,0,0,0,0,0,0,1,,1)\nCYCLE800(2,\"TISCH\",200001,57,0,"
        "5,0,0,0,0,0,0,0,1,,1)\n"
        "G0 X1 Y2 Z3",
        2, 7, 3);
    expect_place("CYCLE800(0,\"A\",0,57,1,2,3,0,0,0,0,0,0,0)\nCYCLE800()\nG0 X1 Y2 Z3", 1, 2, 3);
    expect_place(
        "CYCLE800(0,\"A\",0,57,1,2,3,0,0,0,0,0,0,0)\nCYCLE800(0,\"0\",0,57,0,0,0,0,0,0,0,0,0,1)"
        "\nG0 X1 Y2 Z3",
        1, 2, 3);
    expect_place("CYCLE800(0,\"A\",0,57,1,2,3,0,0,0,0,0,0,0)\nCYCLE800\nG0 X1 Y2 Z3", 1, 2, 3);
}

TEST(SinumerikFrames, RotationInThePlaneByCycle800NeedsNoMachine) {
    expect_place("CYCLE800(0,\"A\",0,57,0,0,0,0,0,90,5,0,0,0)\nG0 X10 Y0 Z1", 0, 15, 1);
}

TEST(SinumerikFrames, TiltedPlaneNeedsAMachine) {
    const Made r = run(sinumerik("CYCLE800(1,\"A\",0,57,0,0,0,30,0,0,0,0,0,-1)"));
    EXPECT_TRUE(r.says("kinematics"));
    EXPECT_TRUE(r.result.refused);
    EXPECT_TRUE(run(sinumerik("ROT X30")).says("kinematics"));
}

TEST(SinumerikFrames, TiltedPlaneOnAMachine) {
    const auto cradle = std::make_shared<language_test::Cradle>();
    const auto in = [&](const std::string& blocks) {
        return run(sinumerik(blocks), {}, Dialect::Sinumerik, false, cradle);
    };
    const Made r =
        in("CYCLE800(0,\"A\",0,57,0,0,10,30,0,0,0,0,0,-1)\nG0 X1 Y0 Z0\nG1 Z-2 F100\nCYCLE800()");
    EXPECT_EQ(r.errors(), "");
    // Z of the plane leans by 30 degrees about X.
    EXPECT_NEAR(r.end().x.mm(), 1.0, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), 1.0, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), 10.0 - 2.0 * std::sqrt(3.0) / 2.0, 1e-9);
    EXPECT_NEAR(std::abs(r.end().a.degrees()), 30.0, 1e-9);
    // ROT tilts the plane, and turns no axis.
    const Made rot = in("ROT X30\nG0 X1 Y0 Z0");
    EXPECT_EQ(rot.errors(), "");
    EXPECT_NEAR(rot.end().a.degrees(), 0.0, 1e-9);
    // A retraction is reported.
    EXPECT_TRUE(
        in("CYCLE800(1,\"A\",0,57,0,0,10,30,0,0,0,0,0,-1)\nG0 X1 Y0 Z0").says("machine-point"));
}

TEST(SinumerikFrames, OrderOfTheAxesOfCycle800) {
    // 27: Z, Y, X; the angles are in the order of the axes.
    expect_place("CYCLE800(0,\"A\",0,27,0,0,0,90,0,0,0,0,0,0)\nG0 X10 Y0 Z1", 0, 10, 1);
    expect_refused("CYCLE800(0,\"A\",0,64,0,0,0,90,0,0,0,0,0,0)",
                   "5:1: CYCLE800 with solid, projected or direct angles (MODE) is not read; the "
                   "program is stopped here [not-read]");
    expect_refused("TRANS X1\nCYCLE800(0,\"A\",0,57,0,0,0,0,0,9,0,0,0,0)",
                   "6:1: CYCLE800 behind TRANS, ROT, SCALE or MIRROR is not read; the program is "
                   "stopped here [not-read]");
    expect_refused("CYCLE800(0,\"A\",12,57,0,0,0,0,0,9,0,0,0,0)",
                   "5:1: CYCLE800 with ST=12 is not read; the program is stopped here [not-read]");
}

TEST(SinumerikFrames, TipControl) {
    const auto cradle = std::make_shared<language_test::Cradle>();
    const Made r = run(sinumerik("TRAORI\nG0 X1 Y0 Z0\nG1 A=30 F100\nA3=0 B3=0 C3=1\nTRAFOOF"), {},
                       Dialect::Sinumerik, false, cradle);
    EXPECT_EQ(r.errors(), "");
    expect_refused(
        "A3=0 B3=0 C3=1",
        "5:1: A3, B3, C3 needs TRAORI before; the program is stopped here [word-missing]");
    EXPECT_EQ(run(sinumerik("TRAORI\nG0 X1\nTRAFOOF")).errors(), "");
}

TEST(SinumerikFrames, TurnAlongAGreatCircleIsReported) {
    const auto cradle = std::make_shared<language_test::Cradle>();
    const auto is_reported = [&](const std::string& blocks) {
        return run(sinumerik("TRAORI\n" + blocks + "\nTRAFOOF"), {}, Dialect::Sinumerik, false,
                   cradle)
            .says("turn-by-vector");
    };
    EXPECT_TRUE(is_reported("ORIWKS ORIVECT\nG1 X1 A=30 C=20 F100"));
    // Small turns, turns of one axis, rapid moves and linear axes.
    EXPECT_FALSE(is_reported("ORIWKS ORIVECT\nG1 X1 A=0.5 C=0.5 F100"));
    EXPECT_FALSE(is_reported("ORIWKS ORIVECT\nG1 X1 A=30 F100"));
    EXPECT_FALSE(is_reported("ORIWKS ORIVECT\nG0 X1 A=30 C=20"));
    EXPECT_FALSE(is_reported("ORIMKS ORIAXES\nG1 X1 A=30 C=20 F100"));
    EXPECT_FALSE(is_reported("G1 X1 A=30 C=20 F100"));
}

}  // namespace
}  // namespace ncsim::gcode::sinumerik_test
