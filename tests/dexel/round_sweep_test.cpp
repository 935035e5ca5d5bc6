// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares exact sweeps of round tools with the tool at many positions.
#include "round_sweep.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ncsim::dexel {
namespace {

constexpr cda::Lattice kLattice{1e-5};

// Returns the radius of the tool's profile at `height` (mm). The code is independent of the tested
// code.
double profile_radius(const cda::RoundSweep& tool, double height) {
    if (height >= tool.tip_height) return tool.radius;
    if (tool.is_cone)
        return tool.flat_radius + (tool.radius - tool.flat_radius) * height / tool.tip_height;
    const double r = tool.tip_height;
    return tool.flat_radius + std::sqrt(std::max(0.0, r * r - (r - height) * (r - height)));
}

double profile_height(const cda::RoundSweep& tool, double radius) {
    double low = 0.0, high = tool.tip_height;
    if (profile_radius(tool, 0.0) >= radius) return 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (profile_radius(tool, middle) < radius ? low : high) = middle;
    }
    return high;
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

// Adds the range of a ray within the tool at rest, with the lowest point of the tool at `tip`.
void add_at(const cda::RoundSweep& tool, Vec3 tip, std::size_t axis, Vec3 on_ray, Range& range) {
    const auto add = [&](double low, double high) {
        range.low = std::min(range.low, low);
        range.high = std::max(range.high, high);
    };
    if (axis == 2) {
        const double away = std::hypot(on_ray.x - tip.x, on_ray.y - tip.y);
        if (away <= tool.radius) add(tip.z + profile_height(tool, away), tip.z + tool.height);
        return;
    }
    const double height = on_ray.z - tip.z;
    if (height < 0.0 || height > tool.height) return;
    const double r = profile_radius(tool, height);
    const double aside = axis == 0 ? on_ray.y - tip.y : on_ray.x - tip.x;
    const double middle = axis == 0 ? tip.x : tip.y;
    if (std::abs(aside) > r) return;
    const double half = std::sqrt(r * r - aside * aside);
    add(middle - half, middle + half);
}

cda::RoundSweep random_sweep(test::Random& random) {
    cda::RoundSweep sweep;
    sweep.radius = random.within(0.5, 4);
    switch (random.next() % 4) {
        case 0: sweep.flat_radius = sweep.radius; break;
        case 1: sweep.tip_height = sweep.radius; break;
        case 2:
            sweep.flat_radius = sweep.radius * random.within(0.1, 0.9);
            sweep.tip_height = sweep.radius - sweep.flat_radius;
            break;
        default:
            sweep.is_cone = true;
            sweep.flat_radius = random.one_in(2) ? 0.0 : sweep.radius * random.within(0.1, 0.9);
            sweep.tip_height = random.within(0.1, 6);
    }
    sweep.height = sweep.tip_height + (random.one_in(4) ? 0.0 : random.within(0, 8));
    if (sweep.height == 0.0) sweep.height = 1.0;
    sweep.from = {random.within(-5, 5), random.within(-5, 5), random.within(-5, 5)};
    sweep.to = sweep.from;
    // Motions are straight down, level, along an axis, or arbitrary.
    for (int axis = 0; axis < 3; ++axis) {
        if (!random.one_in(3)) sweep.to[axis] += random.within(-6, 6);
    }
    for (const Vec3& end : {sweep.from, sweep.to}) {
        sweep.bounds.add(end - Vec3{sweep.radius, sweep.radius, 0});
        sweep.bounds.add(end + Vec3{sweep.radius, sweep.radius, sweep.height});
    }
    return sweep;
}

const Grid& any_grid() {
    static const Grid kGrid({-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}, 1e5);
    return kGrid;
}

struct Met {
    double low, high, s_low, s_high;
};

std::optional<Met> meet(const SweptTool& tool, std::size_t axis, double u, double v) {
    RowMeeting row;
    tool.intersect_row(axis, &u, 1, v, Lanes::Two, row);
    if (row.low[0] > row.high[0]) return std::nullopt;
    return Met{row.low[0], row.high[0], row.s_low[0], row.s_high[0]};
}

TEST(SweptTool, MeetsRaysWhereTheToolComesBy) {
    test::Random random(11);
    int met = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const cda::RoundSweep sweep = random_sweep(random);
        const SweptTool tool(sweep, kLattice, any_grid());
        const std::size_t axis = random.next() % 3;
        const Vec3 ray{random.within(-8, 8), random.within(-8, 8), random.within(-8, 12)};
        Range expected;
        constexpr int kSteps = 2000;
        for (int i = 0; i <= kSteps; ++i) {
            const double s = static_cast<double>(i) / kSteps;
            add_at(sweep, sweep.from + s * (sweep.to - sweep.from), axis, ray, expected);
        }
        const auto coordinate = [&](std::size_t a) { return ray[static_cast<int>(a % 3)] / 1e-5; };
        const auto found = meet(tool, axis, coordinate(axis + 1), coordinate(axis + 2));
        SCOPED_TRACE(testing::Message() << trial << " axis " << axis);
        if (expected.low > expected.high) {
            // Between two steps the tool may just touch the ray.
            if (found) {
                EXPECT_LT((found->high - found->low) * 1e-5, 0.5);
            }
            continue;
        }
        // At a step the tool may just touch the ray.
        if (!found) {
            EXPECT_LT(expected.high - expected.low, 0.01);
            continue;
        }
        ++met;
        // The range of sampled steps is smaller than the exact range, by far on steep surfaces.
        EXPECT_LE(found->low * 1e-5, expected.low + 1e-7);
        EXPECT_GE(found->high * 1e-5, expected.high - 1e-7);
        EXPECT_NEAR(found->low * 1e-5, expected.low, 0.25);
        EXPECT_NEAR(found->high * 1e-5, expected.high, 0.25);
        // At the reported time, the tool is at the reported place.
        for (const auto& [at, s] :
             {std::pair{found->low, found->s_low}, {found->high, found->s_high}}) {
            Range there;
            Vec3 nudged = ray;
            add_at(sweep, sweep.from + s * (sweep.to - sweep.from), axis, nudged, there);
            if (there.low > there.high) continue;  // on the rim
            EXPECT_NEAR(std::min(std::abs(there.low - at * 1e-5), std::abs(there.high - at * 1e-5)),
                        0.0, 1e-4);
        }
    }
    EXPECT_GT(met, 400);
}

// If the surface is smooth, its normal is perpendicular to the slopes between neighbouring rays.
TEST(SweptTool, NormalsAreAcrossTheSurface) {
    test::Random random(12);
    int smooth = 0;
    for (int trial = 0; trial < 30000; ++trial) {
        const SweptTool tool(random_sweep(random), kLattice, any_grid());
        const std::size_t axis = random.next() % 3;
        const double u = random.within(-5e5, 5e5), v = random.within(-5e5, 5e5);
        for (const bool is_high : {false, true}) {
            const auto at = [&](double du, double dv) {
                const auto found = meet(tool, axis, u + du, v + dv);
                return !found ? std::nan("") : is_high ? found->high : found->low;
            };
            const double here = at(0, 0);
            if (std::isnan(here)) continue;
            // Uses both neighbours. If their slopes differ, there is an edge in between.
            const auto slope = [&](double du, double dv) {
                const double step = du + dv;
                const double there = (at(du, dv) - here) / step;
                const double back = (here - at(-du, -dv)) / step;
                return std::abs(there - back) < 0.02 * (1 + std::abs(there)) ? 0.5 * (there + back)
                                                                             : std::nan("");
            };
            const double along_u = slope(50, 0), along_v = slope(0, 50);
            if (std::isnan(along_u) || std::isnan(along_v)) continue;
            // On a steeper surface, rays 50 units apart are no neighbours.
            if (std::abs(along_u) > 10 || std::abs(along_v) > 10) continue;
            const auto found = meet(tool, axis, u, v);
            const Vec3 n = normalized(
                tool.normal(axis, u, v, is_high, here, is_high ? found->s_high : found->s_low));
            const auto a = static_cast<int>(axis);
            EXPECT_NEAR(n[(a + 1) % 3] + n[a] * along_u, 0.0, 0.02)
                << trial << " axis " << axis << " high " << is_high;
            EXPECT_NEAR(n[(a + 2) % 3] + n[a] * along_v, 0.0, 0.02)
                << trial << " axis " << axis << " high " << is_high;
            EXPECT_GE(is_high ? n[a] : -n[a], -1e-6);
            ++smooth;
        }
    }
    EXPECT_GT(smooth, 5000);
}

// Results for two rays at a time, and for as many as this machine can process, are equal to the
// last bit.
TEST(SweptTool, DoesNotDependOnHowManyRaysAreLookedAtTogether) {
    test::Random random(13);
    std::vector<double> u;
    for (int i = -40; i < 40; ++i)
        u.push_back(2e4 * i + 0.5);
    RowMeeting by_two, by_four;
    for (int trial = 0; trial < 3000; ++trial) {
        const SweptTool tool(random_sweep(random), kLattice, any_grid());
        const std::size_t axis = random.next() % 3;
        const double v = std::floor(random.within(-8e5, 8e5)) + 0.5;
        tool.intersect_row(axis, u.data(), u.size(), v, Lanes::Two, by_two);
        tool.intersect_row(axis, u.data(), u.size(), v, widest_lanes(), by_four);
        EXPECT_EQ(by_two.low, by_four.low) << trial;
        EXPECT_EQ(by_two.high, by_four.high) << trial;
        EXPECT_EQ(by_two.s_low, by_four.s_low) << trial;
        EXPECT_EQ(by_two.s_high, by_four.s_high) << trial;
    }
}

// On no ray of a block is the tool below its plane and parabola, or below the least bound.
TEST(SweptTool, GetsNoLowerInABlockThanItsBound) {
    test::Random random(15);
    BlockBounds bounds;
    int near = 0, met = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const SweptTool tool(random_sweep(random), kLattice, any_grid());
        const double pitch = std::floor(random.within(2e3, 4e4));
        const double x = std::floor(random.within(-9e5, 9e5)) + 0.5;
        const double y = std::floor(random.within(-9e5, 9e5)) + 0.5;
        const double half = 0.5 * static_cast<double>(kBlock - 1) * pitch;
        const BlockExtent column{x + half, half}, band{y + half, half};
        const Lanes lanes = random.one_in(2) ? Lanes::Two : widest_lanes();
        tool.bound_blocks(&column, 1, band, lanes, bounds);
        const BlockBound bound = bounds[0];
        LowestBlock lowest;
        lowest.slope_x = random.one_in(3) ? 0.0 : random.within(-1, 1);
        lowest.slope_y = random.one_in(3) ? 0.0 : random.within(-1, 1);
        const double above = tool.lowest_above(bound, lowest, half, half);
        double found = 1e30;
        std::array<double, kBlock> u{};
        for (std::size_t i = 0; i < kBlock; ++i)
            u[i] = x + static_cast<double>(i) * pitch;
        RowMeeting row;
        for (std::size_t k = 0; k < kBlock; ++k) {
            const double v = y + static_cast<double>(k) * pitch;
            tool.intersect_row(2, u.data(), kBlock, v, Lanes::Two, row);
            for (std::size_t i = 0; i < kBlock; ++i) {
                if (row.low[i] > 1e29) continue;
                const double plane =
                    lowest.slope_x * (u[i] - column.middle) + lowest.slope_y * (v - band.middle);
                EXPECT_GE(std::nearbyint(row.low[i]), bound.least) << trial;
                EXPECT_GE(std::nearbyint(row.low[i]) - plane, above - 1e-3) << trial;
                found = std::min(found, row.low[i]);
            }
        }
        if (found > 1e29) continue;
        ++met;
        near += found - bound.least < 0.3 * half ? 1 : 0;
    }
    EXPECT_GT(met, 3000);
    EXPECT_GT(near, met / 2);
}

// Compares cutting tool by tool with taking the lowest tool, which skips tools if the bound
// permits.
TEST(SweptTool, IsTheLowestOfSeveralWhereItIsLowest) {
    test::Random random(15);
    std::array<double, kBlock> x{}, y{};
    BlockBounds bounds;
    for (const Lanes lanes : {Lanes::Two, widest_lanes()}) {
        for (int trial = 0; trial < 3000; ++trial) {
            const double left = random.within(-8e5, 8e5), front = random.within(-8e5, 8e5);
            for (std::size_t i = 0; i < kBlock; ++i) {
                x[i] = left + 2e4 * static_cast<double>(i);
                y[i] = front + 2e4 * static_cast<double>(i);
            }
            const BlockExtent column{0.5 * (x[0] + x[kBlock - 1]), 0.5 * (x[kBlock - 1] - x[0])};
            const BlockExtent band{0.5 * (y[0] + y[kBlock - 1]), 0.5 * (y[kBlock - 1] - y[0])};
            LowestBlock lowest;
            lowest.at.fill(3e5);
            lowest.number.fill(-1.0);
            lowest.group_highest.fill(3e5);
            lowest.highest = 3e5;
            std::vector<double> expected(kBlock * kBlock, 3e5), number(kBlock * kBlock, -1.0);
            for (int k = 0; k < 4; ++k) {
                const SweptTool tool(random_sweep(random), kLattice, any_grid());
                tool.bound_blocks(&column, 1, band, lanes, bounds);
                tool.lower_block(x.data(), y.data(), kBlock, bounds[0], k, lanes, lowest);
                RowMeeting row;
                for (std::size_t j = 0; j < kBlock; ++j) {
                    tool.intersect_row(2, x.data(), kBlock, y[j], Lanes::Two, row);
                    for (std::size_t i = 0; i < kBlock; ++i) {
                        const double low = std::nearbyint(row.low[i]);
                        if (low >= expected[j * kBlock + i]) continue;
                        expected[j * kBlock + i] = low;
                        number[j * kBlock + i] = k;
                    }
                }
                EXPECT_EQ(lowest.highest, *std::ranges::max_element(expected));
            }
            for (std::size_t i = 0; i < kBlock * kBlock; ++i) {
                EXPECT_EQ(lowest.at[i], expected[i]);
                EXPECT_EQ(lowest.number[i], number[i]);
            }
        }
    }
}

TEST(SweptTool, ReachesWhatItsRaysAlongZMeet) {
    test::Random random(14);
    for (int trial = 0; trial < 3000; ++trial) {
        const SweptTool tool(random_sweep(random), kLattice, any_grid());
        const double y = random.within(-9e5, 9e5), x = random.within(-1e6, 1e6);
        const auto [low, high] = tool.reach_along_x(y);
        if (meet(tool, 2, x, y)) {
            EXPECT_LE(low, x);
            EXPECT_GE(high, x);
            const double lowest = meet(tool, 2, x, y)->low;
            EXPECT_LE(tool.lowest_at(y), lowest + 1e-3);
        }
    }
}

}  // namespace
}  // namespace ncsim::dexel
