// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/closest_approach.h"

#include "nightly/round_tool.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ncsim::nightly {
namespace {

Gauge gauge_of(const RoundTool& tool) {
    return [&tool](const Vec& p_T) { return tool.signed_distance(p_T); };
}

TEST(ClosestApproach, OfABallOnAStraightWayIsTheDistanceFromASegment) {
    const RoundTool ball = RoundTool::end_mill(6, 3, 3);  // half a ball about (0, 0, 3)
    const Course course = Course::straight({{0, 0, 0}, {}}, {{10, 0, 0}, {}});
    for (const double gap : {1.0, 1e-3, 1e-6, 1e-9}) {
        const Vec p{4, 3 + gap, 2.0};
        const double exact = std::hypot(3 + gap, 1.0) - 3;
        const Bounds above = closest_approach(gauge_of(ball), course, p, exact - 1e-11);
        EXPECT_GT(above.lower, exact - 1e-11);
        const Bounds below = closest_approach(gauge_of(ball), course, p, exact + 1e-11);
        EXPECT_LE(below.upper, exact + 1e-11);
    }
}

TEST(ClosestApproach, UnderAFlatBottomNeedsNoMoreThanAFewLooks) {
    // A distance that is constant during the motion.
    const RoundTool flat = RoundTool::end_mill(10, 0, 20);
    const Course course = Course::straight({{-100, 0, 0}, {}}, {{100, 0, 0}, {}});
    int looks = 0;
    const Gauge counted = [&](const Vec& p_T) {
        ++looks;
        return flat.signed_distance(p_T);
    };
    EXPECT_GT(closest_approach(counted, course, {0, 0, -1e-6}, 0.9e-6).lower, 0.9e-6);
    EXPECT_LT(looks, 40);
}

// All kinds of paths, compared with the minimum over many poses. `dense` bounds by how much the
// tool can come closer between two poses.
TEST(ClosestApproach, AgreesWithManyPoses) {
    test::Random random(1);
    const std::vector<RoundTool> tools{
        RoundTool::end_mill(10, 0, 25), RoundTool::end_mill(6, 3, 20),
        RoundTool::end_mill(12, 2, 25), RoundTool::cone(6, 0, 30, 20),
        RoundTool::cone(8, 1, 118, 20), RoundTool::tapered(3, 1.5, 5, 30),
    };
    const auto somewhere = [&](double reach) {
        return Vec{random.within(-reach, reach), random.within(-reach, reach),
                   random.within(-reach, reach)};
    };
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        const Axes from{somewhere(20), random.one_in(2) ? Vec{} : somewhere(90)};
        const Axes to{somewhere(20), random.one_in(2) ? from.turn : somewhere(90)};
        const auto plane = static_cast<std::size_t>(random.between(0, 2));
        const Course course =
            random.one_in(2)
                ? Course::straight(from, to)
                : Course::arc(from, to, plane, (plane + 1) % 3, {random.unit(), random.unit()},
                              random.one_in(2), static_cast<int>(random.between(0, 2)));
        const RoundTool& tool = tools[static_cast<std::size_t>(i) % tools.size()];
        const Vec p = somewhere(25);
        constexpr int kPoses = 20000;
        double best = 1e9;
        double longest = 0.0;
        Vec before = course.to_tool(0.0, p);
        for (int k = 0; k <= kPoses; ++k) {
            const Vec at = course.to_tool(static_cast<double>(k) / kPoses, p);
            best = std::min(best, tool.signed_distance(at));
            longest = std::max(longest, norm(at - before));
            before = at;
        }
        const double least = best - longest / 2 - 1e-9;  // no pose is closer
        const Bounds clear = closest_approach(gauge_of(tool), course, p, least - 1e-9);
        EXPECT_GT(clear.lower, least - 1e-9);
        EXPECT_LE(clear.lower, best + 1e-9);
        const Bounds met = closest_approach(gauge_of(tool), course, p, best + 1e-9);
        EXPECT_LE(met.upper, best + 1e-9);
        EXPECT_GE(met.upper, least);
    }
}

TEST(ClosestApproach, ThatIsCutOffClaimsNothing) {
    const RoundTool ball = RoundTool::end_mill(6, 3, 20);
    const Course course = Course::arc({{10, 0, 0}, {}}, {{10, 0, 0}, {}}, 0, 1, {}, true, 0);
    // 0.1 nm above the cut: the decision takes many steps.
    const Bounds b = closest_approach(gauge_of(ball), course, {0, 13 + 1e-7, 5}, 0.9e-7, 3);
    EXPECT_FALSE(b.lower > 0.9e-7);
    EXPECT_FALSE(b.upper <= 0.9e-7);
    EXPECT_GT(closest_approach(gauge_of(ball), course, {0, 13 + 1e-7, 5}, 0.9e-7).lower, 0.9e-7);
}

}  // namespace
}  // namespace ncsim::nightly
