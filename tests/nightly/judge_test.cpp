// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/judge.h"

#include <gtest/gtest.h>

namespace ncsim::nightly {
namespace {

// Returns a block of 40 x 30 x 10 mm with a slot along X, 10 mm wide and 2 mm deep.
Program slot(const Course& course) {
    Program program;
    program.stock = {{-20, -15, -10}, {20, 15, 0}, false};
    program.tools.push_back(RoundTool::end_mill(10, 0, 30));
    program.moves.push_back({course, 0, 1});
    program.tolerance_mm = 0.005;
    program.tool_tolerance_mm = 0.05;
    return program;
}

const StatedAccuracy kStated{1e-5, {0.05}, 0.005, 0.005};

TEST(Judge, KnowsAnAxisParallelSlotToTheNanometre) {
    const Program program = slot(Course::straight({{-30, 0, -2}, {}}, {{30, 0, -2}, {}}));
    const Judge judge(program, kStated);
    for (const double nm : {1e-6, 1e-3, 1.0}) {
        EXPECT_EQ(judge({0, 5 + nm, -1}), Verdict::Material) << nm;
        EXPECT_EQ(judge({0, 5 - nm, -1}), Verdict::Empty) << nm;
        EXPECT_EQ(judge({0, 0, -2 - nm}), Verdict::Material) << nm;
        EXPECT_EQ(judge({0, 0, -2 + nm}), Verdict::Empty) << nm;
    }
    EXPECT_EQ(judge({0, 12, -10.000001}), Verdict::Empty) << "outside of the stock";
    EXPECT_EQ(judge({0, 12, -9.999999}), Verdict::Material);
}

TEST(Judge, LeavesOpenWhatRoundingToTheLatticeMayChange) {
    // 3 nm off the lattice.
    const Program program = slot(Course::straight({{-30, 3e-6, -2}, {}}, {{30, 3e-6, -2}, {}}));
    const Judge judge(program, kStated);
    EXPECT_EQ(judge({0, 5 + 4e-6, -1}), Verdict::Open);
    EXPECT_EQ(judge({0, 5 + 7e-6, -1}), Verdict::Material);
    EXPECT_EQ(judge({0, 5 - 1e-6, -1}), Verdict::Empty);
}

TEST(Judge, AllowsAnObliqueSlotThePolygonOfTheTool) {
    const Program program = slot(Course::straight({{-30, -30, -2}, {}}, {{30, 30, -2}, {}}));
    const Judge judge(program, kStated);
    const double diagonal = std::sqrt(0.5);
    const auto beside = [&](double d) { return Vec{-d * diagonal, d * diagonal, -1}; };
    EXPECT_EQ(judge(beside(5 - 1e-6)), Verdict::Empty);
    EXPECT_EQ(judge(beside(5 + 0.02)), Verdict::Open);
    EXPECT_EQ(judge(beside(5 + 0.0501)), Verdict::Material);
    // Below the floor of the slot the verdict is Material.
    EXPECT_EQ(judge({0, 0, -2.00001}), Verdict::Material);
}

TEST(Judge, AllowsAnArcItsChords) {
    const Program program =
        slot(Course::arc({{10, 0, -2}, {}}, {{10, 0, -2}, {}}, 0, 1, {0, 0}, true, 0));
    const Judge judge(program, kStated);
    EXPECT_EQ(judge({0, 5 + 0.006, -1}), Verdict::Empty);
    EXPECT_EQ(judge({0, 5 + 0.004, -1}), Verdict::Open);
    EXPECT_EQ(judge({0, 5 - 0.056, -1}), Verdict::Material);
    EXPECT_EQ(judge({0, -10, -1}), Verdict::Empty);
}

TEST(LatticeUnit, Is10NanometresUpTo335Millimetres) {
    EXPECT_EQ(lattice_unit({{0, 0, -335.5}, {335, 1, 0}}), 1e-5);
    EXPECT_EQ(lattice_unit({{0, 0, -335.6}, {335, 1, 0}}), 2e-5);
    EXPECT_EQ(lattice_unit({{0, 0, 0}, {5000, 1, 1}}), 2e-4);
}

}  // namespace
}  // namespace ncsim::nightly
