// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares cutting by rows, which skips rays without contact, with cutting each ray separately.
#include "cutter.h"

#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::dexel {
namespace {

using test::kLattice;
using test::mm_box;

Grid grid_of(double pitch_mm) {
    return {{0, 0, 0}, {1e6, 8e5, 6e5}, pitch_mm * 1e5};
}

cda::RoundSweep sweep_of(test::Random& random, std::uint32_t motion) {
    cda::RoundSweep sweep;
    sweep.radius = random.within(0.3, 2);
    sweep.flat_radius = random.one_in(3) ? sweep.radius : sweep.radius * random.within(0, 0.8);
    if (random.one_in(3)) sweep.flat_radius = 0.0;
    sweep.is_cone = random.one_in(3) && sweep.flat_radius < sweep.radius;
    sweep.tip_height = sweep.is_cone ? random.within(0.2, 2) : sweep.radius - sweep.flat_radius;
    sweep.height = sweep.tip_height + random.within(0.5, 20);
    sweep.from = {random.within(-1, 11), random.within(-1, 9), random.within(0, 6)};
    sweep.to = sweep.from + Vec3{random.within(-3, 3), random.within(-3, 3), random.within(-1, 1)};
    if (random.one_in(3)) sweep.to.z = sweep.from.z;
    if (random.one_in(5)) sweep.to = sweep.from + Vec3{0, 0, random.within(-3, 3)};
    sweep.origin = cda::Origin{motion};
    for (const Vec3& end : {sweep.from, sweep.to}) {
        sweep.bounds.add(end - Vec3{sweep.radius, sweep.radius, 0});
        sweep.bounds.add(end + Vec3{sweep.radius, sweep.radius, sweep.height});
    }
    return sweep;
}

Rays stock_rays(const Grid& grid, std::size_t axis) {
    Rays rays(grid, axis);
    Cutter(grid, rays).fill(CuttingCell(mm_box(0, 0, 0, 10, 8, 6), kLattice, grid));
    return rays;
}

// Cuts each ray separately, without skipping.
void cut_slowly(const Grid& grid, Rays& rays, const SweptTool& tool) {
    RowMeeting met;
    for (std::size_t v = 0; v < rays.rows(); ++v) {
        const std::vector<double>& u = grid.axes[rays.u_axis()].at;
        for (std::size_t i = 0; i < u.size(); ++i) {
            tool.intersect_row(rays.axis(), &u[i], 1, grid.axes[rays.v_axis()].at[v], Lanes::Two,
                               met);
            const auto units = [](double x) {
                return static_cast<std::int32_t>(std::lround(std::clamp(x, -1e9, 1e9)));
            };
            const std::int32_t low = units(met.low[0]), high = units(met.high[0]);
            if (low >= high) continue;
            rays.row(v)[i].cut(low, high, [&](bool below) {
                End end;
                end.at = below ? low : high;
                end.origin = tool.origin;
                return end;
            });
        }
    }
}

void expect_same(const Rays& found, const Rays& expected) {
    ASSERT_EQ(found.all().size(), expected.all().size());
    for (std::size_t i = 0; i < found.all().size(); ++i) {
        const auto a = found.all()[i].intervals(), b = expected.all()[i].intervals();
        ASSERT_EQ(a.size(), b.size()) << i;
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(a[k].low.at, b[k].low.at);
            EXPECT_EQ(a[k].high.at, b[k].high.at);
            EXPECT_EQ(a[k].low.origin, b[k].low.origin);
            EXPECT_EQ(a[k].high.origin, b[k].high.origin);
        }
    }
}

std::vector<const Body*> pointers_to(const std::vector<Body>& bodies) {
    std::vector<const Body*> all;
    for (const Body& body : bodies)
        all.push_back(&body);
    return all;
}

TEST(Cutter, CutsWhatEachRayByItselfLoses) {
    const Grid grid = grid_of(0.4);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        test::Random random(seed);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE(testing::Message() << seed << " axis " << axis);
            Rays fast = stock_rays(grid, axis), slow = stock_rays(grid, axis);
            std::vector<Body> bodies;
            for (std::uint32_t motion = 1; motion < 25; ++motion) {
                const SweptTool tool(sweep_of(random, motion), kLattice, grid);
                bodies.emplace_back(tool);
                cut_slowly(grid, slow, tool);
            }
            // Pending cuts are completed at the end of each call.
            const std::vector<const Body*> all = pointers_to(bodies);
            const auto half = all.begin() + 12;
            Cutter(grid, fast).cut({all.begin(), half}, 0, fast.rows());
            Cutter(grid, fast).cut({half, all.end()}, 0, fast.rows());
            expect_same(fast, slow);
        }
    }
}

// Boxes have faces in common planes. The first box with an end in a plane names the end.
TEST(Cutter, TheFirstOfSeveralNamesAnEnd) {
    const Grid grid = grid_of(0.4);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(300 + seed);
        std::vector<Body> bodies;
        const auto within = [&](std::int64_t most) {
            return static_cast<std::int64_t>(random.next() % static_cast<std::uint64_t>(most));
        };
        for (std::uint32_t motion = 1; motion < 30; ++motion) {
            const std::int64_t x = within(10), y = within(8), z = within(6);
            bodies.emplace_back(CuttingCell(mm_box(x, y, z, x + 1 + within(3), y + 1 + within(3),
                                                   z + 1 + within(3), cda::Origin{motion}),
                                            kLattice, grid));
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE(testing::Message() << seed << " axis " << axis);
            Rays together = stock_rays(grid, axis), apart = stock_rays(grid, axis);
            const std::vector<const Body*> all = pointers_to(bodies);
            Cutter(grid, together).cut(all, 0, together.rows());
            for (const Body* body : all)
                Cutter(grid, apart).cut({&body, 1}, 0, apart.rows());
            expect_same(together, apart);
        }
    }
}

}  // namespace
}  // namespace ncsim::dexel
