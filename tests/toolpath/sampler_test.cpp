// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/sampler.h"

#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/kinematics.h"

#include "positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ncsim::toolpath {
namespace {

using gcode::Length;
using gcode::Motion;
using gcode::Position;

Motion line(Position from, Position to) {
    Motion m;
    m.action = gcode::Linear{from, to};
    return m;
}

Motion arc(Position from, Position to, gcode::Plane plane, double c1, double c2, int turns) {
    Motion m;
    m.action = gcode::Arc{from, to, plane, Length::from_mm(c1), Length::from_mm(c2), turns, {}};
    return m;
}

const ToolExtent kTool = extent_of(flat_end_mill(8.0, 30.0));

// Compared with the path at 20,000 positions.
TEST(ExtentOfPath, OfArcsAndSpiralsIsExact) {
    std::mt19937 random(7);
    const auto number = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random() >> 5) / 134217728.0;
    };
    for (int i = 0; i < 400; ++i) {
        const double c1 = number(-50, 50), c2 = number(-50, 50);
        const double r0 = number(0.1, 80);
        const double r1 = i % 2 ? r0 : r0 * (i % 4 ? number(0.9, 1.1) : number(0.05, 5));
        const double a0 = number(0, 6.28), a1 = number(0, 6.28);
        const int turns = static_cast<int>(random() % 7) - 3;
        constexpr gcode::Plane kPlanes[] = {gcode::Plane::XY, gcode::Plane::ZX, gcode::Plane::YZ};
        const gcode::Plane plane = kPlanes[i % 3];
        const auto place = [&](double first, double second, double third) {
            return plane == gcode::Plane::XY   ? at(first, second, third)
                   : plane == gcode::Plane::ZX ? at(second, third, first)
                                               : at(third, first, second);
        };
        const Motion m = arc(place(c1 + r0 * std::cos(a0), c2 + r0 * std::sin(a0), number(-9, 9)),
                             place(c1 + r1 * std::cos(a1), c2 + r1 * std::sin(a1), number(-9, 9)),
                             plane, c1, c2, turns == 0 ? 1 : turns);
        const Box exact = extent_of_path(m, {nullptr, m});
        SamplingOptions fine;
        fine.chord_tolerance_mm = 1e-9;
        fine.max_steps = 20000;
        Box seen;
        for (const Pose& p : sample(m, {}, fine).poses)
            seen.add(p.translation);
        for (int axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE(i);
            EXPECT_LE(exact.min[axis], seen.min[axis] + 1e-11);
            EXPECT_GE(exact.max[axis], seen.max[axis] - 1e-11);
            EXPECT_NEAR(exact.min[axis], seen.min[axis], 2e-5);
            EXPECT_NEAR(exact.max[axis], seen.max[axis], 2e-5);
        }
    }
}

TEST(ExtentOfPath, OfAQuarterAndAHundredThousandTurns) {
    const auto extent_of = [](const Motion& m) { return extent_of_path(m, {nullptr, m}); };
    const Box quarter = extent_of(arc(at(10, 0, 0), at(0, 10, 0), gcode::Plane::XY, 0, 0, 1));
    EXPECT_EQ(quarter, (Box{{0, 0, 0}, {10, 10, 0}}));
    const Box many = extent_of(arc(at(10, 0, 0), at(10, 0, -5), gcode::Plane::XY, 0, 0, -100000));
    EXPECT_EQ(many, (Box{{-10, -10, -5}, {10, 10, 0}}));
}

TEST(Sample, OfADwellIsEmpty) {
    Motion m;
    m.action = gcode::Dwell{1.0};
    EXPECT_TRUE(sample(m, kTool, {}).poses.empty());
}

TEST(Sample, OfAStraightMoveIsItsEndsAndExact) {
    const Samples s = sample(line(at(0, 0, 0), at(10, 20, -3)), kTool, {});
    ASSERT_EQ(s.poses.size(), 2U);
    EXPECT_EQ(s.poses[1].translation, (Vec3{10, 20, -3}));
    EXPECT_EQ(s.bounds, SampleBounds{});
}

TEST(Sample, OfAMoveThatGoesNowhereIsTwoEqualPoses) {
    const Samples s = sample(line(at(1, 2, 3), at(1, 2, 3)), kTool, {});
    ASSERT_EQ(s.poses.size(), 2U);
    EXPECT_EQ(s.poses[0], s.poses[1]);
}

// Returns the largest measured distance of a chord's midpoint from the circle.
double worst_sagitta(const Samples& s, Vec3 centre, double r) {
    double worst = 0;
    for (std::size_t i = 1; i < s.poses.size(); ++i) {
        const Vec3 middle = 0.5 * (s.poses[i - 1].translation + s.poses[i].translation);
        worst =
            std::max(worst, std::abs(norm(Vec3{middle.x - centre.x, middle.y - centre.y, 0}) - r));
    }
    return worst;
}

TEST(Sample, OfAQuarterCircleKeepsTheChordToleranceAndItsEnds) {
    const Samples s = sample(arc(at(10, 0, 0), at(0, 10, 0), gcode::Plane::XY, 0, 0, 1), kTool, {});
    EXPECT_EQ(s.poses.front().translation, (Vec3{10, 0, 0}));
    EXPECT_EQ(s.poses.back().translation, (Vec3{0, 10, 0}));
    EXPECT_LE(s.bounds.missed_mm, 0.005);
    const double worst = worst_sagitta(s, {}, 10);
    EXPECT_LE(worst, s.bounds.missed_mm);
    EXPECT_GT(worst, 0.8 * s.bounds.missed_mm) << "the bound is not far from the truth";
    for (const Pose& p : s.poses)
        EXPECT_NEAR(norm(p.translation), 10, 1e-12);
    for (const Pose& p : s.poses)
        EXPECT_GE(p.translation.x, 0) << "the short way round";
}

TEST(Sample, ClockwiseGoesTheOtherWayRound) {
    const Samples s =
        sample(arc(at(10, 0, 0), at(0, 10, 0), gcode::Plane::XY, 0, 0, -1), kTool, {});
    double lowest = 0;
    for (const Pose& p : s.poses)
        lowest = std::min(lowest, p.translation.y);
    EXPECT_NEAR(lowest, -10, 0.01);
}

TEST(Sample, EqualEndsAreAFullCircle) {
    const Samples s =
        sample(arc(at(10, 0, 0), at(10, 0, 0), gcode::Plane::XY, 5, 0, -1), kTool, {0.1});
    EXPECT_GE(s.poses.size(), 4U);
    double left = 10;
    for (const Pose& p : s.poses)
        left = std::min(left, p.translation.x);
    EXPECT_LT(left, 1.0);
}

TEST(Sample, TurnsAddFullCircles) {
    const auto sampled = [](int turns) {
        return sample(arc(at(10, 0, 0), at(0, 10, -6), gcode::Plane::XY, 0, 0, turns), kTool, {});
    };
    const std::size_t quarter = sampled(1).poses.size() - 1;
    EXPECT_NEAR(static_cast<double>(sampled(3).poses.size() - 1),
                9.0 * static_cast<double>(quarter), 9.0);
    EXPECT_EQ(sampled(3).poses.back().translation, (Vec3{0, 10, -6}));
}

TEST(Sample, TurnsOfAHelixStandAboveEachOther) {
    const Motion helix =
        arc(at(76.468, 35.766, 0), at(76.468, 35.766, -12), gcode::Plane::XY, 72.891, 35.766, 3);
    const Samples samples = sample(helix, kTool, {});
    ASSERT_EQ((samples.poses.size() - 1) % 3, 0U);
    const std::size_t turn = (samples.poses.size() - 1) / 3;
    for (std::size_t i = turn; i < samples.poses.size(); ++i) {
        const Vec3 above = samples.poses[i - turn].translation;
        const Vec3 here = samples.poses[i].translation;
        EXPECT_NEAR(here.x, above.x, 1e-9);
        EXPECT_NEAR(here.y, above.y, 1e-9);
        EXPECT_NEAR(here.z, above.z - 4.0, 1e-9);
    }
}

TEST(Sample, HelicesDescendInStepWithTheAngle) {
    const Samples s =
        sample(arc(at(10, 0, 0), at(-10, 0, -4), gcode::Plane::XY, 0, 0, 1), kTool, {});
    const std::size_t n = s.poses.size() - 1;
    EXPECT_NEAR(s.poses[n / 2].translation.z,
                -4.0 * static_cast<double>(n / 2) / static_cast<double>(n), 1e-12);
}

TEST(Sample, PlanesHaveTheirAxesInTheOrderOfTheStandard) {
    // G18: Z is the first axis, X the second; a quarter from +Z to +X is counter-clockwise.
    const Samples zx =
        sample(arc(at(0, 7, 10), at(10, 7, 0), gcode::Plane::ZX, 0, 0, 1), kTool, {0.5});
    for (const Pose& p : zx.poses) {
        EXPECT_GE(p.translation.x, 0);
        EXPECT_GE(p.translation.z, 0);
        EXPECT_EQ(p.translation.y, 7);
    }
    const Samples yz =
        sample(arc(at(7, 10, 0), at(7, 0, 10), gcode::Plane::YZ, 0, 0, 1), kTool, {0.5});
    for (const Pose& p : yz.poses)
        EXPECT_GE(p.translation.y, 0);
}

TEST(Sample, UnequalRadiiMakeASpiral) {
    const Samples s =
        sample(arc(at(10, 0, 0), at(-20, 0, 0), gcode::Plane::XY, 0, 0, 1), kTool, {});
    EXPECT_NEAR(norm(s.poses[(s.poses.size() - 1) / 2].translation), 15, 0.2);
    EXPECT_LE(s.bounds.missed_mm, 0.005);
}

TEST(Sample, ATurningToolIsDividedUntilBothBoundsHold) {
    const SamplingOptions options;
    const Samples s = sample(line(at(0, 0, 10, 0), at(20, 0, 10, 10)), kTool, options);
    EXPECT_GT(s.poses.size(), 10U);
    EXPECT_LE(s.bounds.missed_mm, options.rotation_miss_mm);
    EXPECT_LE(s.bounds.gained_mm, options.rotation_gain_mm);
    // Miss bound against the exact deviation: a point of the tool between two poses and the chord
    // of the point's path.
    const Vec3 p_T{0, 5, 29};
    const std::size_t n = s.poses.size() - 1;
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
        const Vec3 truth = pose_at(at(20 * t, 0, 10, 10 * t)) * p_T;
        const Vec3 chord = 0.5 * (s.poses[i] * p_T + s.poses[i + 1] * p_T);
        worst = std::max(worst, norm(truth - chord));
    }
    EXPECT_LE(worst, s.bounds.missed_mm);
}

// The arc and the rotation together; each alone would need fewer steps for the tolerance.
TEST(Sample, OfAnArcThatTurnsTheToolKeepsTheToleranceOfBoth) {
    const SamplingOptions options;
    for (const double turn : {1.0, 5.0, 20.0, 125.0}) {
        Motion m = arc(at(10, 0, 10, 0), at(0, 10, 10, turn), gcode::Plane::XY, 0, 0, 1);
        const Samples s = sample(m, kTool, options);
        EXPECT_LE(s.bounds.missed_mm, options.rotation_miss_mm) << turn;
    }
}

// High above a relevant box, no volume is missed or gained; the path must still have enough steps
// for drawing.
TEST(Sample, ATurnIsNeverOneStepThroughThePart) {
    const Box place{{-10, -10, -10}, {10, 10, 10}};
    const Motion m = line(at(0, 0, 80), at(0, 0, 80, 720));
    const Samples samples = sample(m, kTool, {}, place);
    ASSERT_GE(samples.poses.size(), 145U);
    for (std::size_t i = 1; i < samples.poses.size(); ++i) {
        const Vec3 middle = 0.5 * (samples.poses[i - 1].translation + samples.poses[i].translation);
        EXPECT_GT(norm(middle), 79.9);
    }
}

TEST(Sample, StopsAtMaxStepsAndSaysWhatThatCosts) {
    SamplingOptions options;
    options.max_steps = 10;
    const Samples s = sample(line(at(0, 0, 10, 0), at(0, 0, 10, 3600)), kTool, options);
    EXPECT_EQ(s.poses.size(), 11U);
    EXPECT_GT(s.bounds.gained_mm, 1.0);
}

TEST(Sample, OfACubicSplineStaysOnTheCurve) {
    // A Bézier curve as a B-spline with a known midpoint: (0 + 3·0 + 3·10 + 10)/8, (0 + 3·10 + 3·10
    // + 0)/8.
    gcode::Spline spline;
    spline.from = at(0, 0, -1);
    spline.to = at(10, 0, -1);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.0, 10.0}, {10.0, 10.0}, {10.0, 0.0}}) {
        spline.control_points.push_back({Length::from_mm(x), Length::from_mm(y), 1.0});
    }
    spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    Motion m;
    m.action = spline;
    const Samples s = sample(m, kTool, {});
    EXPECT_EQ(s.poses.front().translation, (Vec3{0, 0, -1}));
    EXPECT_EQ(s.poses.back().translation, (Vec3{10, 0, -1}));
    EXPECT_TRUE(std::any_of(s.poses.begin(), s.poses.end(), [](const Pose& p) {
        return norm(p.translation - Vec3{5, 7.5, -1}) < 1e-9;
    }));
    EXPECT_LE(s.bounds.missed_mm, 0.005);
    EXPECT_GT(s.poses.size(), 20U);
}

TEST(Sample, ASplineThatMakesNoSenseIsAStraightLine) {
    gcode::Spline spline;
    spline.from = at(0, 0, 0);
    spline.to = at(10, 0, 0);
    Motion m;
    m.action = spline;
    EXPECT_EQ(sample(m, kTool, {}).poses.size(), 2U);
}

}  // namespace
}  // namespace ncsim::toolpath
