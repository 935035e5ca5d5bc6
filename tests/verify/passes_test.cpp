// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions that an upright tool has passed.
#include "passes.h"

#include "verified.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::verify {
namespace {

using toolpath::Pose;

struct Way {
    Pose from, to;
    toolpath::Step step() const { return {from, to, {}, {}, {}, {}, false, {}, {}}; }
};

Way way(Vec3 a, Vec3 b) {
    Way w;
    w.from.translation = a;
    w.to.translation = b;
    return w;
}

TEST(Passes, CoverWhatGoesTheSameWayNoLower) {
    Passes passes;
    EXPECT_FALSE(passes.cover(way({0, 0, 0}, {9, 0, 0}).step(), 1.0));
    passes.add(way({0, 0, -2}, {9, 0, -3}).step());
    EXPECT_TRUE(passes.cover(way({0, 0, -2}, {9, 0, -3}).step(), 0.0));
    EXPECT_TRUE(passes.cover(way({9, 0, -3}, {0, 0, -2}).step(), 0.0)) << "back";
    EXPECT_FALSE(passes.cover(way({9, 0, -2}, {0, 0, -3}).step(), 0.0)) << "lower at one end";
    EXPECT_TRUE(passes.cover(way({9, 0, -2}, {0, 0, -3}).step(), 1.0));
    EXPECT_TRUE(passes.cover(way({0, 0, -5}, {9, 0, -6}).step(), 3.0));
    EXPECT_FALSE(passes.cover(way({0, 0, -5}, {9, 0, -6}).step(), 2.999));
    EXPECT_FALSE(passes.cover(way({0, 0, 0}, {8, 0, 0}).step(), 9.0)) << "another way";
}

TEST(Passes, KeepTheLowerOneAndOfThoseThatCrossTheFirst) {
    Passes passes;
    passes.add(way({0, 0, -2}, {9, 0, -2}).step());
    passes.add(way({0, 0, -4}, {9, 0, -4}).step());
    passes.add(way({0, 0, -3}, {9, 0, -3}).step());
    EXPECT_TRUE(passes.cover(way({0, 0, -4}, {9, 0, -4}).step(), 0.0));
    passes.add(way({0, 0, -9}, {9, 0, -1}).step());
    EXPECT_FALSE(passes.cover(way({0, 0, -9}, {9, 0, -4}).step(), 0.0));
    EXPECT_TRUE(passes.cover(way({0, 0, -4}, {9, 0, -4}).step(), 0.0));
    passes.add(way({0, 0, -1}, {9, 0, -9}).step());
    EXPECT_FALSE(passes.cover(way({0, 0, -1}, {9, 0, -9}).step(), 0.0));
    EXPECT_TRUE(passes.cover(way({0, 0, -4}, {9, 0, -4}).step(), 0.0));
}

TEST(Passes, StraightDownReachToTheirLowerEnd) {
    Passes passes;
    passes.add(way({1, 2, 5}, {1, 2, -4}).step());
    EXPECT_TRUE(passes.cover(way({1, 2, -4}, {1, 2, 5}).step(), 0.0));
    EXPECT_TRUE(passes.cover(way({1, 2, 3}, {1, 2, -4}).step(), 0.0));
    EXPECT_FALSE(passes.cover(way({1, 2, 3}, {1, 2, -4.001}).step(), 0.0));
    EXPECT_FALSE(passes.cover(way({1, 3, 3}, {1, 3, 2}).step(), 0.0));
    passes.add(way({1, 2, 0}, {1, 2, -6}).step());
    EXPECT_TRUE(passes.cover(way({1, 2, 9}, {1, 2, -6}).step(), 0.0));
}

TEST(Passes, AreThoseOfAnUprightTool) {
    Passes passes;
    Way leaning = way({0, 0, 0}, {9, 0, 0});
    leaning.from.rows = leaning.to.rows = {Vec3{1, 0, 0}, Vec3{0, 0.8, 0.6}, Vec3{0, -0.6, 0.8}};
    passes.add(leaning.step());
    EXPECT_FALSE(passes.cover(leaning.step(), 0.0));
    EXPECT_FALSE(passes.cover(way({0, 0, 0}, {9, 0, 0}).step(), 0.0));
}

// True if more than the specified 3 mm of flutes is needed. The part of the tool above the flutes
// may only enter space that the flutes have cleared.
bool needs_longer_flutes(const std::string& program, Setup setup = verify_test::plain_setup()) {
    setup.tools.at(1).certain_flutes = 3.0;
    return verify_test::doubts_of(verify_test::verdict_of(program, setup)).contains("flutes-guess");
}

TEST(Passes, DoNotHideThatFlutesAreTooShort) {
    const std::string head = "G21 G90\nT1 M6\nS5000 M3 F500\nG0 X-30 Y0 Z2\n";
    const auto level = [](double z, double to) {
        return "G1 Z" + std::to_string(z) + "\nG1 X" + std::to_string(to) + "\nG1 X-30\n";
    };
    EXPECT_FALSE(needs_longer_flutes(head + level(-3, 30) + level(-6, 30) + level(-9, 30)));
    EXPECT_FALSE(needs_longer_flutes(head + level(-3, 30) + level(-6, 10)));
    EXPECT_TRUE(needs_longer_flutes(head + level(-4, 30)));
    EXPECT_TRUE(needs_longer_flutes(head + level(-2, 30) + level(-6, 30)))
        << "the first was not deep enough";
    EXPECT_TRUE(needs_longer_flutes(head + level(-3, 0) + level(-6, 10)))
        << "the first ended before";
    EXPECT_TRUE(needs_longer_flutes(head + level(-3, 30) + "G0 Z2\nG0 Y4\n" + level(-6, 30)))
        << "the first was beside it";
    EXPECT_TRUE(needs_longer_flutes(head + level(0, 30) + level(-6, 30)))
        << "the first was above the block";
}

// The move is already an error, unless the rule is disabled.
TEST(UncertainFlutes, AreNotDoubtedWhereARapidMoveCuts) {
    const std::string program = "G21 G90\nT1 M6\nS5000 M3 F500\nG0 X-30 Y0 Z2\nG0 Z-6\nG0 X30\n";
    const auto verdict = verify_test::verdict_of(program);
    EXPECT_EQ(verify_test::findings_of(verdict, "rapid-in-material").size(), 1U);
    EXPECT_FALSE(needs_longer_flutes(program));
    EXPECT_TRUE(needs_longer_flutes(program + "(ncsim: ignore rapid-in-material)\nG0 X-30 Y4\n"));
    verify::Setup setup = verify_test::plain_setup();
    setup.selection.ignored.emplace("rapid-in-material", "");
    EXPECT_TRUE(needs_longer_flutes(program, setup));
}

}  // namespace
}  // namespace ncsim::verify
