// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hole cycles of SINUMERIK. Heights, patterns and modal calls are in tests/programs/sinumerik-*.
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode::sinumerik_test {
namespace {

TEST(SinumerikCycles, Drilling) {
    expect_equal("F100\nCYCLE81(10,0,2,-5)", "G0 Z2\nG1 Z-5 F100\nG0 Z10");
    expect_equal("F100\nCYCLE81(10,1,2,,5)", "G0 Z3\nG1 Z-4 F100\nG0 Z10");
}

TEST(SinumerikCycles, SameHolesAsInIso) {
    expect_same("F100\nMCALL CYCLE81(5,0,2,-3)\nX10 Y10\nX20\nMCALL\nG0 X0",
                "G0 X10. Y10.\nZ2.\nG1 Z-3. F100\nG0 Z5.\nX20.\nZ2.\nG1 Z-3.\nG0 Z5.\nX0.");
}

TEST(SinumerikCycles, FactorsThatAreNotUnderstood) {
    expect_refused("CYCLE83(10,0,5,,20,,4,90,0,0.5,100,1,0,1.2,1.4,0,1.6,0,1,11211111)",
                   "5:1: CYCLE83 with a percentage for DAM is not read; the program is stopped "
                   "here [not-read]");
    expect_refused(
        "CYCLE83(10,0,5,,20,,4,-0.8)",
        "5:1: CYCLE83 with a factor for DAM is not read; the program is stopped here [not-read]");
    expect_refused("CYCLE81(10,0,5,-3,,0,1)",
                   "5:1: CYCLE81 with _GMODE is not read; the program is stopped here [not-read]");
    EXPECT_EQ(
        run(sinumerik("F100\nCYCLE83(10,0,5,,20,,4,100,0,0.5,100,1,0,1.2,1.4,0,1.6,0,1,11211111)"))
            .errors(),
        "");
}

TEST(SinumerikCycles, UnitsOfThePitchInTapping) {
    // _PTAB: unit of the pitch. 0: as the program, 1: mm, 2: turns per inch, 3: inches.
    const auto feed = [](const std::string& unit, const std::string& pitch) {
        return run(sinumerik(unit + "\nCYCLE84(16,10,5,1,,0,3,," + pitch)).moves[2].feed;
    };
    EXPECT_NEAR(feed("G710", "2,0,100,,,0)"), 200.0, 1e-9);
    EXPECT_NEAR(feed("G710", "2,0,100,,,1)"), 200.0, 1e-9);
    EXPECT_NEAR(feed("G710", "20,0,100,,,2)"), 127.0, 1e-9);
    EXPECT_NEAR(feed("G710", "0.1,0,100,,,3)"), 254.0, 1e-9);
    EXPECT_NEAR(feed("G700", "0.1,0,100)"), 254.0, 1e-9);
    EXPECT_NEAR(feed("G700", "2,0,100,,,1)"), 200.0, 1e-9);
    EXPECT_NEAR(feed("G700", "20,0,100,,,2)"), 127.0, 1e-9);
    EXPECT_NEAR(feed("G700", "0.1,0,100,,,3)"), 254.0, 1e-9);
    expect_refused(
        "CYCLE84(16,10,5,1)",
        "5:1: CYCLE84 needs a pitch (MPIT or PIT); the program is stopped here [word-missing]");
}

TEST(SinumerikCycles, FaultsOfHoles) {
    expect_refused(
        "CYCLE81(5,0,2)",
        "5:1: CYCLE81 needs RTP, RFP and a depth; the program is stopped here [word-missing]");
    expect_refused(
        "CYCLE81(5,0,2,,)",
        "5:1: CYCLE81 needs a depth (DP or DPR); the program is stopped here [word-missing]");
    expect_refused("CYCLE81(5,0,2,3)",
                   "5:1: the depth of CYCLE81 is above the reference plane; the program is stopped "
                   "here [depth-positive]");
    expect_refused(
        "CYCLE81(-5,0,2,-3)",
        "5:1: CYCLE81 needs a retraction plane (RTP) not below the reference plane (RFP); "
        "the program is stopped here [word-missing]");
    expect_refused(
        "G41\nCYCLE81(5,0,2,-3)",
        "6:1: CYCLE81 under G41 or G42 is not read; the program is stopped here [not-read]");
    expect_refused("CYCLE83(5,0,2,-6,,,1EX-9)",
                   "5:1: the number of repeats must be 1 or more, and not without end "
                   "[cycle-repeats]");
}

TEST(SinumerikCycles, CyclesInOtherPlanes) {
    expect_equal("G18\nG0 Y20\nF100\nCYCLE81(10,0,2,-5)",
                 "G18\nG0 Y20\nG0 Y2\nG1 Y-5 F100\nG0 Y10");
}

}  // namespace
}  // namespace ncsim::gcode::sinumerik_test
