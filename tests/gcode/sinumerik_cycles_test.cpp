// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hole cycles of SINUMERIK, patterns and modal calls.
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode::sinumerik_test {
namespace {

/// Heights of the ends of the moves of `blocks`, from Z50 on.
std::vector<double> heights(const std::string& blocks) {
    const Made r = run(sinumerik(blocks));
    EXPECT_EQ(r.errors(), "") << blocks;
    std::vector<double> z;
    for (std::size_t i = 1; i < r.moves.size(); ++i)
        z.push_back(std::round(end_of(r.moves[i])->z.mm() * 1e9) / 1e9);
    return z;
}
using Heights = std::vector<double>;

TEST(SinumerikCycles, Drilling) {
    expect_equal("F100\nCYCLE81(10,0,2,-5)", "G0 Z2\nG1 Z-5 F100\nG0 Z10");
    expect_equal("F100\nCYCLE81(10,1,2,,5)", "G0 Z3\nG1 Z-4 F100\nG0 Z10");
}

TEST(SinumerikCycles, RelativeDepthWins) {
    EXPECT_EQ(heights("F100\nCYCLE81(10,1,2,-9,5)"), (Heights{3, -4, 10}));
    EXPECT_EQ(heights("F100\nCYCLE81(10,1,2,-9,0)"), (Heights{3, -9, 10}));
}

TEST(SinumerikCycles, SameHolesAsInIso) {
    expect_same("F100\nMCALL CYCLE81(5,0,2,-3)\nX10 Y10\nX20\nMCALL\nG0 X0",
                "G0 X10. Y10.\nZ2.\nG1 Z-3. F100\nG0 Z5.\nX20.\nZ2.\nG1 Z-3.\nG0 Z5.\nX0.");
}

TEST(SinumerikCycles, DwellInSecondsAndTurns) {
    expect_equal("F100\nCYCLE82(10,0,2,-5,,1.5)", "G0 Z2\nG1 Z-5 F100\nG4 F1.5\nG0 Z10");
    expect_equal("F100\nCYCLE82(10,0,2,-5,,-10)", "G0 Z2\nG1 Z-5 F100\nG4 F0.6\nG0 Z10");
}

TEST(SinumerikCycles, DeepHoleWithChipRemoval) {
    // RFP -1, FDEP -2, DAM 0.1, MDEP 0.5: bottoms -2, -2.9, -3.7, -4.4, -5, -5.5, …
    const Heights z = heights("F100\nCYCLE83(5,-1,5,-6.2,,-2,,0.1,0,0,1,1,,0.5,0,0,1)");
    const Heights expected{4,  -2, 4,  -1,   -2.9, 4,    -1.9, -3.7, 4,  -2.7, -4.4, 4, -3.4,
                           -5, 4,  -4, -5.5, 4,    -4.5, -6,   4,    -5, -6.2, 4,    5};
    EXPECT_EQ(z, expected);
}

TEST(SinumerikCycles, DeepHoleWithChipBreaking) {
    EXPECT_EQ(heights("F100\nCYCLE83(5,0,2,-6,,,2,0,0,0,1,0)"),
              (Heights{2, -2, -1, -4, -3, -6, 2, 5}));
    EXPECT_EQ(heights("F100\nCYCLE83(5,0,2,-6,,,2,0,0,0,1,0,,,0.5)"),
              (Heights{2, -2, -1.5, -4, -3.5, -6, 2, 5}));
}

TEST(SinumerikCycles, LastTwoInfeedsAreEqual) {
    EXPECT_EQ(heights("F100\nCYCLE83(5,0,2,-10,,,4,1,0,0,1,0,,,0.5)"),
              (Heights{2, -4, -3.5, -7, -6.5, -8.5, -8, -10, 2, 5}));
}

TEST(SinumerikCycles, FirstFeedOfADeepHole) {
    const Made r = run(sinumerik("F100\nCYCLE83(5,0,2,-6,,,2,0,0,0,0.5,0)"));
    EXPECT_DOUBLE_EQ(r.moves[2].feed, 50.0);
    EXPECT_DOUBLE_EQ(r.moves[4].feed, 100.0);
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

TEST(SinumerikCycles, RigidTapping) {
    const Made r = run(sinumerik("CYCLE84(16,10,5,1,,0,3,,1,0,500,400)"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 5U);
    EXPECT_DOUBLE_EQ(r.moves[2].feed, 500.0);
    EXPECT_DOUBLE_EQ(r.moves[3].feed, 400.0);
    EXPECT_DOUBLE_EQ(r.end().z.mm(), 16.0);
    EXPECT_EQ(r.moves[2].spindle, SpindleTurning::Clockwise);
    EXPECT_EQ(r.moves[3].spindle, SpindleTurning::Counterclockwise);
    EXPECT_EQ(run(sinumerik("CYCLE84(16,10,5,1,,0,3,8,,0,100)")).moves[2].feed, 125.0);
    EXPECT_EQ(run(sinumerik("CYCLE84(16,10,5,1,,0,3,,-2,0,100)")).moves[2].spindle,
              SpindleTurning::Counterclockwise);
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

TEST(SinumerikCycles, TappingWithChipBreaking) {
    EXPECT_EQ(heights("CYCLE84(5,0,5,-6,,0,3,,1,0,100,100,0,1,,1,3,0.5)"),
              (Heights{5, -3, -2.5, -6, 5}));
}

TEST(SinumerikCycles, TappingWithACompensatingChuck) {
    const Made r = run(sinumerik("F200\nCYCLE840(5,0,5,-6,,0,4,3,1,,1)"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_DOUBLE_EQ(r.moves[2].feed, 1000.0);
    EXPECT_EQ(r.moves[2].spindle, SpindleTurning::Clockwise);
    EXPECT_EQ(r.moves[3].spindle, SpindleTurning::Counterclockwise);
    EXPECT_DOUBLE_EQ(run(sinumerik("F200\nCYCLE840(5,0,5,-6)")).moves[2].feed, 200.0);
}

TEST(SinumerikCycles, BoringAndReaming) {
    expect_equal("F100\nCYCLE85(5,0,2,-6,,1,50,80)\nG1 X1",
                 "G0 Z2\nG1 Z-6 F50\nG4 F1\nZ2 F80\nG0 Z5\nG1 X1 F100");
    expect_equal("F100\nCYCLE89(5,0,2,-6,,1)", "G0 Z2\nG1 Z-6 F100\nG4 F1\nZ2\nG0 Z5");
    EXPECT_EQ(heights("F100\nCYCLE86(5,0,2,-6,,0,3,-0.1)"), (Heights{2, -6, 5}));
    EXPECT_EQ(heights("F100\nCYCLE87(5,0,2,-6,,3)"), (Heights{2, -6, 5}));
    EXPECT_EQ(heights("F100\nCYCLE88(5,0,2,-6,,1,3)"), (Heights{2, -6, 5}));
}

TEST(SinumerikCycles, ModalCallsDrillAfterEachMove) {
    EXPECT_EQ(heights("F100\nG0 Z5\nMCALL CYCLE81(5,0,2,-3)\nG0 X1\nC90\nF50\nMCALL\nX2"),
              (Heights{5, 5, 2, -3, 5, 5, 2, -3, 5, 5}));
}

TEST(SinumerikCycles, ADefinitionAloneDoesNotDrill) {
    EXPECT_EQ(heights("MCALL CYCLE81(5,0,2,-3)\nMCALL\nG0 X1"), (Heights{50}));
}

TEST(SinumerikCycles, HolesOnALineAndACircle) {
    const auto holes = [](const std::string& pattern) {
        const Made r = run(sinumerik("F100\nMCALL CYCLE81(5,0,2,-3)\n" + pattern + "\nMCALL"));
        EXPECT_EQ(r.errors(), "");
        std::vector<std::pair<double, double>> places;
        for (const Motion& move : r.moves) {
            const Position& end = *end_of(move);
            if (end.z.mm() == -3.0)
                places.emplace_back(std::round(end.x.mm() * 1e6) / 1e6,
                                    std::round(end.y.mm() * 1e6) / 1e6);
        }
        return places;
    };
    using Places = std::vector<std::pair<double, double>>;
    EXPECT_EQ(holes("HOLES1(10,20,90,5,10,3)"), (Places{{10, 25}, {10, 35}, {10, 45}}));
    EXPECT_EQ(holes("HOLES2(0,0,10,0,90,4)"), (Places{{10, 0}, {0, 10}, {-10, 0}, {0, -10}}));
    EXPECT_EQ(holes("HOLES2(5,5,10,90,0,2)"), (Places{{5, 15}, {5, -5}}));
    EXPECT_EQ(holes("CYCLE801(0,0,0,10,5,2,2)"), (Places{{0, 0}, {10, 0}, {10, 5}, {0, 5}}));
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
    expect_refused("CYCLE81(-5,0,2,-3)",
                   "5:1: CYCLE81 needs a retraction plane (RTP) above the reference plane (RFP); "
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
