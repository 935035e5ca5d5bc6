// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells that a tool removes between two poses.
#include "ncsim/toolpath/trace.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/toolpath/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;

constexpr cda::Lattice kLattice{1e-5};

Pose pose(double x, double y, double z, double a = 0) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = Angle::from_degrees(a);
    return pose_at(p);
}

std::vector<cda::Cell> trace(Cutter& cutter, const Pose& from, const Pose& to) {
    std::vector<cda::Cell> cells;
    cutter.trace(from, to, cda::Origin{7}, cells);
    return cells;
}

cda::ConvexPolytope polytope(const cda::Cell& cell) {
    return *cda::ConvexPolytope::of(cell, kLattice);
}

// True up to the rounding of points to the lattice.
bool inside(const cda::Cell& cell, Vec3 p_mm) {
    for (const cda::Plane& plane : cell.planes) {
        if (dot(unit_normal(plane), p_mm) > offset_mm(plane, kLattice) + 2e-5) return false;
    }
    return true;
}

TEST(Trace, OfAToolAtRestIsTheTool) {
    Cutter cutter(flat_end_mill(10, 20), kLattice, {});
    const auto cells = trace(cutter, pose(1, 2, 3), pose(1, 2, 3));
    ASSERT_EQ(cells.size(), 1U);
    EXPECT_EQ(cells[0].origin, cda::Origin{7});
    EXPECT_EQ(polytope(cells[0]).facets().size(), static_cast<std::size_t>(cutter.sides()) + 2);
}

// Also for a turned tool: depth is measured along the tool axis.
TEST(Trace, TheDeeperTheLowerTheRank) {
    Cutter cutter(flat_end_mill(10, 20), kLattice, {});
    const auto rank = [&cutter](double z0, double z1, double a) {
        return trace(cutter, pose(0, 0, z0, a), pose(5, 0, z1, a)).at(0).rank;
    };
    EXPECT_EQ(rank(-3, -3, 0), -300000);
    EXPECT_EQ(rank(-3, -4, 0), rank(-4, -4, 0));
    for (const double a : {0.0, 30.0, 90.0, 180.0}) {
        SCOPED_TRACE(a);
        EXPECT_LT(rank(-4, -4, a), rank(-3, -3, a));
        EXPECT_LT(rank(-4, -4, a), rank(5, -3, a));
    }
    EXPECT_GT(rank(-1e9, -1e9, 0), cda::Cell::kFirstRank);
}

TEST(Trace, AlongXHasWallsAtExactlyTheRadius) {
    Cutter cutter(flat_end_mill(10, 20), kLattice, {});
    const auto cells = trace(cutter, pose(0, 0, -3), pose(40, 0, -3));
    const cda::ConvexPolytope p = polytope(cells[0]);
    EXPECT_TRUE(p.facet_in({0, 1, 0, 500000}));
    EXPECT_TRUE(p.facet_in({0, -1, 0, 500000}));
    EXPECT_TRUE(p.facet_in({0, 0, -1, 300000}));
    EXPECT_DOUBLE_EQ(cells[0].bounds.max.x, 45.0);
}

TEST(Trace, PlungingKeepsTheSidesOfTheTool) {
    Cutter cutter(flat_end_mill(10, 20), kLattice, {});
    const auto cells = trace(cutter, pose(0, 0, 5), pose(0, 0, -5));
    EXPECT_EQ(polytope(cells[0]).facets().size(), static_cast<std::size_t>(cutter.sides()) + 2);
}

TEST(Trace, OnlyCuttingPiecesLeaveOne) {
    Tool tool = flat_end_mill(10, 20);
    add_holder_segment(tool, 30, 30, 50);
    Cutter cutter(tool, kLattice, {});
    EXPECT_EQ(trace(cutter, pose(0, 0, 0), pose(1, 0, 0)).size(), 1U);
}

TEST(Trace, OfATiltedToolHasATiltedFloor) {
    Cutter cutter(flat_end_mill(10, 20), kLattice, {});
    const auto cells = trace(cutter, pose(0, 0, 0, 10), pose(30, 0, 0, 10));
    ASSERT_EQ(cells.size(), 1U);
    // The normal of the floor is the tool axis, turned by A10, pointing down.
    const SinCos a = sin_cos(10);
    bool found = false;
    for (const cda::Plane& plane : cells[0].planes) {
        found = found || norm(unit_normal(plane) - Vec3{0, a.sin, -a.cos}) < 1e-5;
    }
    EXPECT_TRUE(found);
    EXPECT_TRUE(inside(cells[0], pose(15, 0, 0, 10) * Vec3{0, 4.9, 10}));
}

TEST(Trace, OfATurningToolContainsBothPoses) {
    Cutter cutter(ball_end_mill(6, 20), kLattice, {});
    const Pose from = pose(0, 0, 5, 0);
    const Pose to = pose(5, 0, 5, 2);
    const auto cells = trace(cutter, from, to);
    ASSERT_EQ(cells.size(), 1U);
    for (const Vec3 p_T : {Vec3{0, 0, 0}, Vec3{3, 0, 3}, Vec3{0, -3, 20}, Vec3{2, 2, 15}}) {
        EXPECT_TRUE(inside(cells[0], from * p_T));
        EXPECT_TRUE(inside(cells[0], to * p_T));
    }
}

TEST(Trace, BoundsEncloseTheCells) {
    Cutter cutter(bull_nose_end_mill(8, 1, 15), kLattice, {});
    for (const auto& [from, to] : {std::pair{pose(0, 0, 0), pose(9, -4, 2)},
                                   {pose(0, 0, 0, 30), pose(9, -4, 2, 30)},
                                   {pose(0, 0, 0, 30), pose(9, -4, 2, 31)}}) {
        const Box box = cutter.bounds(from, to);
        for (const cda::Cell& cell : trace(cutter, from, to)) {
            EXPECT_TRUE(box.contains(cell.bounds.min));
            EXPECT_TRUE(box.contains(cell.bounds.max));
        }
    }
}

TEST(Trace, DoesNotDependOnWhatWasTracedBefore) {
    Cutter used(ball_end_mill(6, 20), kLattice, {});
    for (int a = 0; a < 30; ++a)
        trace(used, pose(0, 0, 0, a), pose(1, 0, 0, a));
    Cutter fresh(ball_end_mill(6, 20), kLattice, {});
    EXPECT_EQ(trace(used, pose(0, 0, 0, 3), pose(1, 0, 0, 3))[0].planes,
              trace(fresh, pose(0, 0, 0, 3), pose(1, 0, 0, 3))[0].planes);
}

TEST(KnownStart, NeedsAllThreeAxes) {
    gcode::Motion m;
    EXPECT_TRUE(has_known_start(m));
    m.known_start.y = false;
    EXPECT_FALSE(has_known_start(m));
}

}  // namespace
}  // namespace ncsim::toolpath
