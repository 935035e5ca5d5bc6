// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of paths: corners of dog-legs, boxes that include the start, and the numbers of corners of
// round tools.
#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/machine/presets.h"
#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

Position place(double x, double y, double z) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

TEST(DogLeg, HasACornerWhereAnAxisArrives) {
    RapidPath path;
    path.dog_leg = true;
    path.rates = {10.0, 20.0, 5.0};
    // X needs 1 s, Y 2 s, Z 4 s; A turns all the time.
    gcode::Linear rapid{place(0, 0, 0), place(10, -40, 20)};
    rapid.to.a = Angle::from_degrees(80);
    const auto legs = legs_of(rapid, path);
    ASSERT_EQ(legs.size(), 3U);
    const double x[] = {10, 10, 10}, y[] = {-20, -40, -40}, z[] = {5, 10, 20}, a[] = {20, 40, 80};
    Position at = rapid.from;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(legs[i].from, at) << i;
        at = legs[i].to;
        EXPECT_NEAR(at.x.mm(), x[i], 1e-9) << i;
        EXPECT_NEAR(at.y.mm(), y[i], 1e-9) << i;
        EXPECT_NEAR(at.z.mm(), z[i], 1e-9) << i;
        EXPECT_NEAR(at.a.degrees(), a[i], 1e-9) << i;
    }
    EXPECT_EQ(at, rapid.to);
    // U has the rate of X: 30 mm are the last to arrive.
    gcode::Linear second = rapid;
    second.to.u = Length::from_mm(50);
    const auto longer = legs_of(second, path);
    ASSERT_EQ(longer.size(), 4U);
    EXPECT_NEAR(longer[0].to.u.mm(), 10, 1e-9);
    EXPECT_NEAR(longer[2].to.u.mm(), 40, 1e-9);
    EXPECT_NEAR(longer[2].to.a.degrees(), 64, 1e-9);
}

TEST(DogLeg, IsStraightIfAllAxesArriveTogetherOrOneMoves) {
    RapidPath path;
    path.dog_leg = true;
    path.rates = {10.0, 20.0, 5.0};
    EXPECT_EQ(legs_of({place(0, 0, 0), place(10, 20, -5)}, path).size(), 1U);
    EXPECT_EQ(legs_of({place(0, 0, 0), place(0, 20, 0)}, path).size(), 1U);
    EXPECT_EQ(legs_of({place(1, 2, 3), place(1, 2, 3)}, path).size(), 1U);
    path.dog_leg = false;
    EXPECT_EQ(legs_of({place(0, 0, 0), place(10, 99, 0)}, path).size(), 1U);
}

TEST(ExtentOfJoints, IncludesBothEnds) {
    // Under tip control the head leans from 0 to 60 degrees: the start is the highest place.
    const Kinematics machine{*machine::preset("head-b-table-c"), {}};
    gcode::Motion motion;
    gcode::Linear linear{place(0, 0, 0), place(0, 0, 0)};
    linear.to.b = Angle::from_degrees(60);
    motion.action = linear;
    motion.coordinates = gcode::Coordinates::Tip;
    motion.length = Length::from_mm(100);
    const auto box_at = [&](const Position& p) {
        gcode::Motion still = motion;
        still.action = gcode::Linear{p, p};
        return extent_of_joints(still, machine);
    };
    const Box whole = extent_of_joints(motion, machine);
    for (const Position& end : {linear.from, linear.to}) {
        const Box box = box_at(end);
        ASSERT_FALSE(box.is_empty());
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(whole.min[axis], box.min[axis] + 1e-9);
            EXPECT_GE(whole.max[axis], box.max[axis] - 1e-9);
        }
    }
    // At both ends an axis is extreme: the box is no larger.
    EXPECT_NEAR(whole.max.z, std::max(box_at(linear.from).max.z, box_at(linear.to).max.z), 1e-6);
    EXPECT_NEAR(whole.min.z, std::min(box_at(linear.from).min.z, box_at(linear.to).min.z), 1e-6);
    EXPECT_GT(whole.size().z, 40.0);
}

// Corners and volumes of the polytopes of round tools. A change of these numbers changes the time
// of each simulation; the volumes are within the error that the polytope states.
TEST(PolytopeTable, CornersAndVolumesOfRoundTools) {
    struct Row {
        Tool tool;
        double tolerance_mm;
        Side side;
        bool turns;
        std::size_t corners;
        int sides;
        double volume;  // of the first piece, mm³
    };
    const cda::Lattice lattice{1e-5};
    const auto volume = [&](const PiecePolytope& p) {
        const auto cell = cda::convex_hull(p.points_T, lattice, cda::Origin{1});
        return 1e-15 * cda::ConvexPolytope::of(*cell, lattice)->volume();  // mm³ of (10 nm)³
    };
    const Side around = Side::Circumscribed, within = Side::Inscribed, fair = Side::Fair;
    for (const Row& row :
         std::vector<Row>{{flat_end_mill(10, 20), 0.05, around, false, 48, 24, 1579.832},
                          {flat_end_mill(10, 20), 0.05, within, false, 48, 24, 1552.909},
                          {flat_end_mill(10, 20), 0.05, fair, false, 48, 24, 1579.832},
                          {flat_end_mill(10, 20), 0.05, around, true, 48, 24, 1579.832},
                          {flat_end_mill(10, 20), 0.005, around, false, 144, 72, 1571.797},
                          {flat_end_mill(10, 20), 0.005, within, false, 144, 72, 1568.8},
                          {flat_end_mill(10, 20), 0.005, fair, false, 144, 72, 1571.797},
                          {flat_end_mill(10, 20), 0.005, around, true, 144, 72, 1571.797},
                          {ball_end_mill(6, 20), 0.05, around, false, 136, 24, 541.4368},
                          {ball_end_mill(6, 20), 0.05, within, false, 145, 24, 528.5327},
                          {ball_end_mill(6, 20), 0.05, fair, false, 108, 32, 539.2803},
                          {ball_end_mill(6, 20), 0.05, around, true, 144, 24, 541.6199},
                          {ball_end_mill(6, 20), 0.01, around, false, 696, 48, 538.4651},
                          {ball_end_mill(6, 20), 0.01, within, false, 721, 60, 535.5896},
                          {ball_end_mill(6, 20), 0.01, fair, false, 492, 72, 538.1697},
                          {ball_end_mill(6, 20), 0.01, around, true, 700, 60, 538.1468},
                          {bull_nose_end_mill(12, 2, 20), 0.05, around, false, 192, 32, 2241.969},
                          {bull_nose_end_mill(12, 2, 20), 0.05, within, false, 224, 32, 2213.051},
                          {bull_nose_end_mill(12, 2, 20), 0.05, fair, false, 160, 32, 2241.254},
                          {bull_nose_end_mill(12, 2, 20), 0.05, around, true, 192, 32, 2240.789},
                          {v_cutter(8, 0.4, 60, 15), 0.02, around, false, 108, 36, 540.8724},
                          {v_cutter(8, 0.4, 60, 15), 0.02, within, false, 108, 36, 536.1706},
                          {v_cutter(8, 0.4, 60, 15), 0.02, fair, false, 108, 36, 540.8724},
                          {v_cutter(8, 0.4, 60, 15), 0.02, around, true, 108, 36, 540.8724},
                          {tapered_end_mill(3, 1.5, 5, 20), 0.02, around, false, 204, 40, 333.0701},
                          {tapered_end_mill(3, 1.5, 5, 20), 0.02, within, false, 217, 48, 328.4134},
                          {tapered_end_mill(3, 1.5, 5, 20), 0.02, fair, false, 164, 64, 332.918},
                          {tapered_end_mill(3, 1.5, 5, 20), 0.02, around, true, 216, 48, 333.0721},
                          {lollipop_mill(8), 0.05, around, false, 324, 24, 271.4032},
                          {lollipop_mill(8), 0.05, within, false, 318, 24, 261.4296},
                          {lollipop_mill(8), 0.05, fair, false, 240, 24, 266.3127},
                          {lollipop_mill(8), 0.05, around, true, 312, 24, 271.4398},
                          {drill(5, 118, 30), 0.01, around, false, 81, 40, 570.6911},
                          {drill(5, 118, 30), 0.01, within, false, 81, 40, 566.9607},
                          {drill(5, 118, 30), 0.01, fair, false, 81, 40, 570.6911},
                          {drill(5, 118, 30), 0.01, around, true, 81, 40, 570.6911},
                          {dovetail_mill(16, 30, 5), 0.05, around, false, 64, 32, 689.7722},
                          {dovetail_mill(16, 30, 5), 0.05, within, false, 64, 32, 680.0149},
                          {dovetail_mill(16, 30, 5), 0.05, fair, false, 64, 32, 689.7722},
                          {dovetail_mill(16, 30, 5), 0.05, around, true, 64, 32, 689.7722}}) {
        SCOPED_TRACE(testing::Message() << name_of(row.tool.kind) << ", " << row.tolerance_mm
                                        << ", " << static_cast<int>(row.side) << ", " << row.turns);
        const PiecePolytope made =
            approximate(row.tool.pieces.front(), lattice, {row.tolerance_mm, row.side, row.turns});
        EXPECT_EQ(made.points_T.size(), row.corners);
        EXPECT_EQ(made.sides, row.sides);
        EXPECT_NEAR(volume(made), row.volume, 1e-4 * row.volume);
        EXPECT_LE(made.error_mm, row.tolerance_mm);
    }
}

}  // namespace
}  // namespace ncsim::toolpath
