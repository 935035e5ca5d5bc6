// SPDX-License-Identifier: GPL-3.0-or-later
//
// Course of a tool in a hole: depths from the first contact, states of the spindle on the way out,
// and helices, move by move.
#include "hole_course.h"

#include <gtest/gtest.h>

#include <vector>

namespace ncsim::verify {
namespace {

using gcode::Length;
using gcode::MoveKind;
using gcode::SpindleTurning;

gcode::Position at(double x, double y, double z, double a = 0.0) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = gcode::Angle::from_degrees(a);
    return p;
}

/// Moves of T1 one after another; material ends at Z0.
class Hole {
public:
    explicit Hole(gcode::Position start) : at_(start) {}

    Move go(gcode::Position to, MoveKind kind, bool meets) {
        motion_.action = gcode::Linear{at_, to};
        motion_.kind = kind;
        at_ = to;
        Move move;
        move.motion = &motion_;
        move.meets_material = meets;
        if (meets) move.contact = {{-50, -50, to.z.mm()}, {50, 50, 0}};
        move.radius_mm = radius;
        move.mouth_z = mouth;
        course_.take(move);
        return move;
    }
    void spin(SpindleTurning spindle) { motion_.spindle = spindle; }
    void change_tool(int tool) { motion_.tool = tool; }

    double radius = 0.0;          ///< Radius of the next moves, as if they were arcs.
    std::optional<double> mouth;  ///< Mouth of the next moves.

private:
    gcode::Motion motion_;
    gcode::Position at_;
    HoleCourse course_;
};

TEST(HoleCourse, DepthIsFromTheFirstContact) {
    Hole hole(at(5, 6, 10));
    EXPECT_EQ(hole.go(at(5, 6, 2), MoveKind::Rapid, false).hole_depth_mm, 0.0);
    EXPECT_EQ(hole.go(at(5, 6, -3), MoveKind::Feed, true).hole_depth_mm, 3.0);
    EXPECT_EQ(hole.go(at(5, 6, -7.5), MoveKind::Feed, true).hole_depth_mm, 7.5);
    // Up and down again in the same hole: the top stays.
    EXPECT_EQ(hole.go(at(5, 6, 2), MoveKind::Rapid, false).hole_depth_mm, 0.0);
    EXPECT_EQ(hole.go(at(5, 6, -7), MoveKind::Rapid, false).hole_depth_mm, 0.0);
    EXPECT_EQ(hole.go(at(5, 6, -9), MoveKind::Feed, true).hole_depth_mm, 9.0);
    // Another place, from below the surface: the depth begins at the start.
    hole.go(at(5, 6, -2), MoveKind::Rapid, false);
    hole.go(at(8, 6, -2), MoveKind::Feed, true);
    EXPECT_EQ(hole.go(at(8, 6, -4), MoveKind::Feed, true).hole_depth_mm, 2.0);
}

TEST(HoleCourse, DepthBeginsAtALowerMouth) {
    Hole hole(at(0, 0, 5));
    hole.mouth = -1.5;
    EXPECT_EQ(hole.go(at(0, 0, -4), MoveKind::Feed, true).hole_depth_mm, 2.5);
    Hole higher(at(0, 0, 5));
    higher.mouth = 3.0;
    EXPECT_EQ(higher.go(at(0, 0, -4), MoveKind::Feed, true).hole_depth_mm, 4.0);
}

TEST(HoleCourse, OnlyStraightMovesAlongTheToolAreInAHole) {
    const auto depth = [](gcode::Position from, gcode::Position to, double radius, MoveKind kind) {
        Hole hole(from);
        hole.radius = radius;
        return hole.go(to, kind, true).hole_depth_mm;
    };
    EXPECT_EQ(depth(at(0, 0, 5), at(0, 0, -4), 0.0, MoveKind::Feed), 4.0);
    EXPECT_EQ(depth(at(0, 0, 5), at(1, 0, -4), 0.0, MoveKind::Feed), 0.0);
    EXPECT_EQ(depth(at(0, 0, 5), at(0, 1, -4), 0.0, MoveKind::Feed), 0.0);
    EXPECT_EQ(depth(at(0, 0, 5), at(0, 0, -4), 2.0, MoveKind::Feed), 0.0) << "a helix";
    EXPECT_EQ(depth(at(0, 0, 5, 30), at(0, 0, -4, 30), 0.0, MoveKind::Feed), 0.0) << "turned";
    EXPECT_EQ(depth(at(0, 0, 5), at(0, 0, -4), 0.0, MoveKind::Rapid), 0.0);
}

TEST(HoleCourse, TheWayOutHasTheSpindleOfTheCut) {
    Hole hole(at(0, 0, 5));
    hole.spin(SpindleTurning::Clockwise);
    EXPECT_FALSE(hole.go(at(0, 0, 3), MoveKind::Feed, false).leaves_cut);
    hole.go(at(0, 0, -4), MoveKind::Feed, true);
    hole.spin(SpindleTurning::Stopped);
    const Move out = hole.go(at(0, 0, 5), MoveKind::Rapid, false);
    EXPECT_EQ(out.leaves_cut, SpindleTurning::Clockwise);
    EXPECT_TRUE(out.has_cut_below);
    // The way out is the next move alone; cuts below are known until the tool moves aside.
    const Move higher = hole.go(at(0, 0, 9), MoveKind::Rapid, false);
    EXPECT_FALSE(higher.leaves_cut);
    EXPECT_TRUE(higher.has_cut_below);
    hole.go(at(3, 0, 9), MoveKind::Rapid, false);
    EXPECT_FALSE(hole.go(at(3, 0, 10), MoveKind::Rapid, false).has_cut_below);
    // Downwards there is no way out; another tool has not cut here.
    hole.go(at(3, 0, -4), MoveKind::Feed, true);
    EXPECT_FALSE(hole.go(at(3, 0, -5), MoveKind::Rapid, false).has_cut_below);
    hole.change_tool(2);
    EXPECT_FALSE(hole.go(at(3, 0, 5), MoveKind::Rapid, false).has_cut_below);
}

TEST(HoleCourse, AThreadIsAHelixAtFeedInMaterial) {
    const auto threads = [](gcode::Position to, double radius, MoveKind kind, bool meets) {
        Hole hole(at(0, 0, -5));
        hole.radius = radius;
        EXPECT_FALSE(hole.go(to, kind, meets).has_threaded) << "known for the moves behind";
        hole.radius = 0.0;
        return hole.go(at(0, 0, 5), MoveKind::Rapid, false).has_threaded;
    };
    EXPECT_TRUE(threads(at(0, 0, -4), 6.0, MoveKind::Feed, true)) << "a full turn";
    EXPECT_TRUE(threads(at(1, 0, -4), 0.0, MoveKind::Feed, true));
    EXPECT_TRUE(threads(at(0, 1, -4), 0.0, MoveKind::Feed, true));
    EXPECT_FALSE(threads(at(0, 0, -5), 6.0, MoveKind::Feed, true)) << "level";
    EXPECT_FALSE(threads(at(0, 0, -4), 0.0, MoveKind::Feed, true)) << "straight";
    EXPECT_FALSE(threads(at(0, 0, -4), 6.0, MoveKind::Rapid, true));
    EXPECT_FALSE(threads(at(0, 0, -4), 6.0, MoveKind::Feed, false)) << "in the air";
    Hole hole(at(0, 0, -5));
    hole.radius = 6.0;
    hole.go(at(0, 0, -4), MoveKind::Feed, true);
    hole.change_tool(2);
    EXPECT_FALSE(hole.go(at(0, 0, 5), MoveKind::Rapid, false).has_threaded);
}

}  // namespace
}  // namespace ncsim::verify
