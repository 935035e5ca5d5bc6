// SPDX-License-Identifier: GPL-3.0-or-later
#include "round_sweep.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::dexel {
namespace {

using cda::Vec3;

constexpr cda::Lattice kLattice{1e-5};

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

// Of the tool at rest with its lowest point there; written apart from what is tested.
void add_at(const cda::RoundSweep& sweep, Vec3 tip, std::size_t axis, Vec3 on_ray, Range& range) {
    const auto add = [&](double low, double high) {
        if (low > high) return;
        range.low = std::min(range.low, low);
        range.high = std::max(range.high, high);
    };
    const double r = sweep.radius;
    const double base = tip.z + (sweep.is_ball ? r : 0.0);
    const double top = tip.z + sweep.height;
    const Vec3 off = on_ray - tip;
    if (axis == 2) {
        if (off.x * off.x + off.y * off.y <= r * r) add(base, top);
    } else if (on_ray.z >= base && on_ray.z <= top) {
        const double aside = axis == 0 ? off.y : off.x;
        const double middle = axis == 0 ? tip.x : tip.y;
        const double half = r * r - aside * aside;
        if (half >= 0.0) add(middle - std::sqrt(half), middle + std::sqrt(half));
    }
    if (!sweep.is_ball) return;
    Vec3 away = on_ray - Vec3{tip.x, tip.y, base};
    const auto a = static_cast<int>(axis);
    away[a] = 0.0;
    const double square = r * r - dot(away, away);
    const double middle = axis == 2 ? base : tip[a];
    if (square >= 0.0) add(middle - std::sqrt(square), middle + std::sqrt(square));
}

TEST(SweptTool, MeetsRaysWhereTheToolComesBy) {
    test::Random random(11);
    int met = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        cda::RoundSweep sweep;
        sweep.radius = random.within(0.5, 4);
        sweep.height = sweep.radius + random.within(0, 8);
        sweep.is_ball = random.one_in(2);
        sweep.from = {random.within(-5, 5), random.within(-5, 5), random.within(-5, 5)};
        sweep.to = sweep.from;
        // Straight down, level, along an axis, or anyhow.
        for (int axis = 0; axis < 3; ++axis) {
            if (!random.one_in(3)) sweep.to[axis] += random.within(-6, 6);
        }
        for (const Vec3& end : {sweep.from, sweep.to}) {
            sweep.bounds.add(end - Vec3{sweep.radius, sweep.radius, 0});
            sweep.bounds.add(end + Vec3{sweep.radius, sweep.radius, sweep.height});
        }
        const Grid grid({-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}, 1e5);
        const SweptTool tool(sweep, kLattice, grid);
        const std::size_t axis = random.next() % 3;
        const Vec3 ray{random.within(-8, 8), random.within(-8, 8), random.within(-8, 12)};
        Range expected;
        constexpr int kSteps = 4000;
        for (int i = 0; i <= kSteps; ++i) {
            const double s = static_cast<double>(i) / kSteps;
            add_at(sweep, sweep.from + s * (sweep.to - sweep.from), axis, ray, expected);
        }
        SweptTool::Interval found;
        const auto coordinate = [&](std::size_t a) { return ray[static_cast<int>(a % 3)] / 1e-5; };
        const bool meets = tool.meet(axis, coordinate(axis + 1), coordinate(axis + 2), found);
        SCOPED_TRACE(testing::Message() << trial << " axis " << axis);
        if (expected.low > expected.high) {
            // Between two steps it may just touch.
            if (meets) {
                EXPECT_LT((found.high.at - found.low.at) * 1e-5, 0.5);
            }
            continue;
        }
        ASSERT_TRUE(meets);
        ++met;
        // Steps never reach as far, and where the surface is steep far less.
        EXPECT_LE(found.low.at * 1e-5, expected.low + 1e-9);
        EXPECT_GE(found.high.at * 1e-5, expected.high - 1e-9);
        const double slack = 0.15;
        EXPECT_GE(found.low.at * 1e-5, expected.low - slack);
        EXPECT_LE(found.high.at * 1e-5, expected.high + slack);
        // Out of the tool, against the ray at its lower end and along it at its upper one.
        const auto a = static_cast<int>(axis);
        EXPECT_LE(found.low.normal[a], 1e-6 * norm(found.low.normal));
        EXPECT_GE(found.high.normal[a], -1e-6 * norm(found.high.normal));
    }
    EXPECT_GT(met, 300);
}

// Wherever the surface is smooth, its normal is across what neighbouring rays find.
TEST(SweptTool, NormalsAreAcrossTheSurface) {
    test::Random random(12);
    int smooth = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        cda::RoundSweep sweep;
        sweep.radius = random.within(1, 4);
        sweep.height = sweep.radius + random.within(1, 8);
        sweep.is_ball = random.one_in(2);
        sweep.from = {random.within(-2, 2), random.within(-2, 2), random.within(-2, 2)};
        sweep.to = sweep.from;
        for (int axis = 0; axis < 3; ++axis) {
            if (!random.one_in(3)) sweep.to[axis] += random.within(-6, 6);
        }
        const Grid grid({-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}, 1e5);
        const SweptTool tool(sweep, kLattice, grid);
        const std::size_t axis = random.next() % 3;
        const double u = random.within(-3e5, 3e5), v = random.within(-3e5, 3e5);
        for (const bool is_low : {true, false}) {
            const auto at = [&](double du, double dv, Meeting& meeting) {
                SweptTool::Interval found;
                if (!tool.meet(axis, u + du, v + dv, found)) return false;
                meeting = is_low ? found.low : found.high;
                return true;
            };
            Meeting here;
            if (!at(0, 0, here)) continue;
            // By both neighbours at two distances: where these differ, there is an edge between.
            const auto slope = [&](double du, double dv) {
                Meeting ahead, behind;
                if (!at(du, dv, ahead) || !at(-du, -dv, behind)) return std::nan("");
                const double step = du + dv;
                const double there = (ahead.at - here.at) / step;
                const double back = (here.at - behind.at) / step;
                return std::abs(there - back) < 0.02 * (1 + std::abs(there)) ? 0.5 * (there + back)
                                                                             : std::nan("");
            };
            const double along_u = slope(50, 0), along_v = slope(0, 50);
            if (std::isnan(along_u) || std::isnan(along_v)) continue;
            // Steeper than that, ten units are no neighbours.
            if (std::abs(along_u) > 10 || std::abs(along_v) > 10) continue;
            const Vec3 n = normalized(here.normal);
            const auto a = static_cast<int>(axis);
            EXPECT_NEAR(n[(a + 1) % 3] + n[a] * along_u, 0.0, 0.02)
                << trial << " axis " << axis << " low " << is_low;
            EXPECT_NEAR(n[(a + 2) % 3] + n[a] * along_v, 0.0, 0.02)
                << trial << " axis " << axis << " low " << is_low;
            ++smooth;
        }
    }
    EXPECT_GT(smooth, 5000);
}

}  // namespace
}  // namespace ncsim::dexel
