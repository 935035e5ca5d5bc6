// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/machine.h"

#include <gtest/gtest.h>

namespace ncsim::toolpath {
namespace {

using cda::Vec3;
using gcode::Angle;
using gcode::Length;
using gcode::Position;

Position at(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = Angle::from_degrees(a), p.b = Angle::from_degrees(b), p.c = Angle::from_degrees(c);
    return p;
}

TEST(PoseAt, WithoutRotationTheTipIsWhereTheProgramSays) {
    const Pose X_WT = pose_at(at(1, 2, 3));
    EXPECT_EQ(X_WT.rows, Pose{}.rows);
    EXPECT_EQ(X_WT.translation, (Vec3{1, 2, 3}));
}

TEST(PoseAt, SecondaryAxesAddUp) {
    Position p = at(1, 2, 3);
    p.w = Length::from_mm(-10);
    EXPECT_EQ(pose_at(p).translation, (Vec3{1, 2, -7}));
}

TEST(PoseAt, QuarterTurnsAreExactAndRightHanded) {
    // Above the part, then turned by A90 about X: the tool comes from -y.
    EXPECT_EQ(pose_at(at(5, 0, 30, 90)) * Vec3{}, (Vec3{5, -30, 0}));
    EXPECT_EQ(pose_at(at(0, 0, 30, 0, 90)) * Vec3{}, (Vec3{30, 0, 0}));
    EXPECT_EQ(pose_at(at(30, 0, 0, 0, 0, 90)) * Vec3{}, (Vec3{0, 30, 0}));
}

TEST(PoseAt, TurnsAboutAFirstThenBThenC) {
    const Vec3 p_W = pose_at(at(0, 0, 10, 90, 0, 90)) * Vec3{};
    EXPECT_EQ(p_W, (Vec3{10, 0, 0}));  // A: to -y; C: from -y to +x
}

TEST(PoseAt, AFullTurnIsTheSameOrientation) {
    EXPECT_EQ(pose_at(at(1, 2, 3, 30)).rows, pose_at(at(1, 2, 3, 390)).rows);
}

}  // namespace
}  // namespace ncsim::toolpath
