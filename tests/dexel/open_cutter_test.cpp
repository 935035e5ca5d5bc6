// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares cutting by blocks of rays, which skips tools that are known to stay above, with cutting
// each ray separately.
#include "open_cutter.h"

#include "cutter.h"
#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::dexel {
namespace {

using test::kLattice;
using test::mm_box;

Grid grid_of(double pitch_mm) {
    return {{0, 0, 0}, {1e6, 8e5, 6e5}, pitch_mm * 1e5};
}

cda::RoundSweep open_sweep(test::Random& random, std::uint32_t motion, double longest) {
    cda::RoundSweep sweep;
    sweep.radius = random.within(0.3, 2);
    sweep.flat_radius = random.one_in(3) ? sweep.radius : sweep.radius * random.within(0, 0.8);
    if (random.one_in(2)) sweep.flat_radius = 0.0;
    sweep.is_cone = random.one_in(4) && sweep.flat_radius < sweep.radius;
    sweep.tip_height = sweep.is_cone ? random.within(0.2, 2) : sweep.radius - sweep.flat_radius;
    sweep.height = sweep.tip_height + 20;
    sweep.from = {random.within(-1, 11), random.within(-1, 9), random.within(0, 6)};
    sweep.to = sweep.from +
               longest * Vec3{random.within(-1, 1), random.within(-1, 1), random.within(-0.5, 0.5)};
    if (random.one_in(3)) sweep.to.z = sweep.from.z;
    if (random.one_in(4)) sweep.to.y = sweep.from.y;
    if (random.one_in(6)) sweep.to = sweep.from + Vec3{0, 0, random.within(-3, 3)};
    sweep.origin = cda::Origin{motion};
    for (const Vec3& end : {sweep.from, sweep.to}) {
        sweep.bounds.add(end - Vec3{sweep.radius, sweep.radius, 0});
        sweep.bounds.add(end + Vec3{sweep.radius, sweep.radius, sweep.height});
    }
    return sweep;
}

Rays stock_rays(const Grid& grid) {
    Rays rays(grid, 2);
    Cutter(grid, rays).fill(CuttingCell(mm_box(0, 0, 0, 10, 8, 6), kLattice, grid));
    return rays;
}

void expect_same(const Rays& found, const Rays& expected) {
    ASSERT_EQ(found.all().size(), expected.all().size());
    for (std::size_t i = 0; i < found.all().size(); ++i) {
        const auto a = found.all()[i].intervals(), b = expected.all()[i].intervals();
        ASSERT_EQ(a.size(), b.size()) << i;
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(a[k].low.at, b[k].low.at);
            EXPECT_EQ(a[k].high.at, b[k].high.at);
            EXPECT_EQ(a[k].high.origin, b[k].high.origin);
            EXPECT_EQ(a[k].high.normal.u, b[k].high.normal.u);
            EXPECT_EQ(a[k].high.normal.v, b[k].high.normal.v);
        }
    }
}

// Cuts each ray at the lowest point that a tool reaches, tool by tool.
Rays cut_slowly(const Grid& grid, const std::vector<SweptTool>& tools) {
    Rays rays = stock_rays(grid);
    RowMeeting met;
    const std::vector<double>&x = grid.axes[0].at, &y = grid.axes[1].at;
    for (std::size_t row = 0; row < rays.rows(); ++row) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const SweptTool* lowest = nullptr;
            double at = 1e9, s = 0.0;
            for (const SweptTool& tool : tools) {
                tool.intersect_row(2, &x[i], 1, y[row], Lanes::Two, met);
                const double low = std::nearbyint(met.low[0]);
                if (met.low[0] >= met.high[0] || low >= at) continue;
                lowest = &tool, at = low, s = met.s_low[0];
            }
            if (!lowest) continue;
            const auto low = static_cast<std::int32_t>(at);
            rays.row(row)[i].cut(low, Gap::kUnbounded, [&](bool) {
                return End{low, lowest->origin,
                           PackedNormal::of(-1.0 * lowest->normal(2, x[i], y[row], false, at, s))};
            });
        }
    }
    return rays;
}

TEST(OpenCutter, CutsWhatEachRayByItselfLoses) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(100 + seed);
        const Grid grid = grid_of(random.one_in(2) ? 0.4 : 0.13);
        const double longest = random.one_in(2) ? 3.0 : 0.2;
        std::vector<SweptTool> tools;
        for (std::uint32_t motion = 1; motion < 60; ++motion) {
            tools.emplace_back(open_sweep(random, motion, longest), kLattice, grid);
            ASSERT_TRUE(tools.back().is_open_above(grid.axes[2].at.back()));
        }
        std::vector<const SweptTool*> all;
        for (const SweptTool& tool : tools)
            all.push_back(&tool);
        const Rays expected = cut_slowly(grid, tools);
        for (const Lanes lanes : {Lanes::Two, widest_lanes()}) {
            Rays rays = stock_rays(grid);
            OpenCutter(grid, rays, lanes).cut(all, 0, rays.bands());
            expect_same(rays, expected);
        }
    }
}

// A raster in pieces of any size. The remaining surface becomes lower with each piece, and the
// bound is known.
TEST(OpenCutter, DoesNotDependOnHowManyComeAtOnce) {
    const Grid grid = grid_of(0.2);
    std::vector<SweptTool> tools;
    std::uint32_t motion = 0;
    for (int row = 0; row < 16; ++row) {
        for (int k = 0; k < 20; ++k) {
            cda::RoundSweep sweep;
            sweep.radius = sweep.tip_height = 1.5;
            sweep.height = 20;
            const auto at = [&](int i) {
                const double x = 0.5 * (row % 2 == 0 ? i : 20 - i), y = 0.5 * row;
                return Vec3{x, y, 3 + std::sin(x) * std::cos(y)};
            };
            sweep.from = at(k), sweep.to = at(k + 1);
            sweep.origin = cda::Origin{++motion};
            for (const Vec3& end : {sweep.from, sweep.to}) {
                sweep.bounds.add(end - Vec3{1.5, 1.5, 0});
                sweep.bounds.add(end + Vec3{1.5, 1.5, 20});
            }
            tools.emplace_back(sweep, kLattice, grid);
        }
    }
    const Rays expected = cut_slowly(grid, tools);
    std::vector<const SweptTool*> all;
    for (const SweptTool& tool : tools)
        all.push_back(&tool);
    for (const std::size_t size : {7U, 40U, 320U}) {
        SCOPED_TRACE(size);
        Rays rays = stock_rays(grid);
        for (std::size_t begin = 0; begin < all.size(); begin += size) {
            const std::span piece =
                std::span(all).subspan(begin, std::min(size, all.size() - begin));
            // Bands come in any order.
            OpenCutter(grid, rays).cut(piece, 2, rays.bands());
            OpenCutter(grid, rays).cut(piece, 0, 2);
        }
        expect_same(rays, expected);
    }
}

// Equal tools, and flat tools at the same depth.
TEST(OpenCutter, TheFirstOfSeveralNamesAnEnd) {
    const Grid grid = grid_of(0.2);
    test::Random random(9);
    std::vector<SweptTool> tools;
    for (std::uint32_t motion = 1; motion < 80; ++motion) {
        cda::RoundSweep sweep;
        sweep.radius = 1.0;
        sweep.flat_radius = 1.0;
        sweep.height = 20;
        sweep.from = {random.within(0, 10), random.within(0, 8), motion % 3 == 0 ? 3.0 : 4.0};
        sweep.to = sweep.from +
                   Vec3{random.within(-2, 2), random.within(-2, 2), motion % 5 == 0 ? 1.0 : 0.0};
        sweep.origin = cda::Origin{motion};
        for (const Vec3& end : {sweep.from, sweep.to}) {
            sweep.bounds.add(end - Vec3{1, 1, 0});
            sweep.bounds.add(end + Vec3{1, 1, 20});
        }
        tools.emplace_back(sweep, kLattice, grid);
        if (motion % 7 == 0) {
            sweep.origin = cda::Origin{++motion};
            tools.emplace_back(sweep, kLattice, grid);
        }
    }
    std::vector<const SweptTool*> all;
    for (const SweptTool& tool : tools)
        all.push_back(&tool);
    Rays rays = stock_rays(grid);
    OpenCutter(grid, rays).cut(all, 0, rays.bands());
    expect_same(rays, cut_slowly(grid, tools));
}

}  // namespace
}  // namespace ncsim::dexel
