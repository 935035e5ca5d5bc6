// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/kinematics.h"

#include "positions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ncsim::toolpath {
namespace {

using gcode::Length;
using gcode::Position;

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
    // Above the part, then A90 about X: the tool comes from -y.
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

TEST(PoseAt, CUnderAnUprightToolMovesItWithoutTurningIt) {
    for (const double c : {1.0, 45.0, 90.0, -137.0, 1000.0})
        EXPECT_EQ(pose_at(at(30, 0, 5, 0, 0, c)).rows, Pose{}.rows);
    EXPECT_EQ(pose_at(at(30, 0, 5, 0, 0, 90)).translation, (Vec3{0, 30, 5}));
    EXPECT_EQ(pose_at(at(0, 0, 0, 180, 180, 17)).rows, Pose{}.rows) << "upright again";
}

TEST(PoseAt, QuarterTurnsOfTwoAxesAreExact) {
    for (const double a : {0.0, 90.0, 180.0, 270.0}) {
        for (const double b : {0.0, 90.0, 180.0, 270.0}) {
            for (const double c : {0.0, 90.0, 180.0, 270.0}) {
                for (const Vec3 row : pose_at(at(0, 0, 0, a, b, c)).rows) {
                    for (int i = 0; i < 3; ++i)
                        EXPECT_TRUE(row[i] == 0.0 || std::abs(row[i]) == 1.0);
                }
            }
        }
    }
}

// The rotation maps z to the tool axis of A, B and C and keeps the line perpendicular to both.
TEST(PoseAt, ARoundToolIsTurnedByTheLeastRotation) {
    for (double a = -179.9999; a < 180.0; a += 29.3) {
        for (double b = -179.9999; b < 180.0; b += 31.7) {
            for (const double c : {0.0, 1.0, 100.0, 250.0}) {
                const Pose X_WT = pose_at(at(0, 0, 0, a, b, c));
                // The image of a tip 1 mm above the origin is the tool axis, too.
                const Vec3 axis = pose_at(at(0, 0, 1, a, b, c)).translation;
                EXPECT_LT(norm(axis_of(X_WT) - axis), 1e-15);
                const Vec3 across{-axis.y, axis.x, 0.0};
                EXPECT_LT(norm(X_WT * across - across), 1e-9);
                for (int i = 0; i < 3; ++i) {
                    for (int k = 0; k < 3; ++k) {
                        const auto& rows = X_WT.rows;
                        const double product = dot(rows[static_cast<std::size_t>(i)],
                                                   rows[static_cast<std::size_t>(k)]);
                        EXPECT_NEAR(product, i == k ? 1.0 : 0.0, 1e-12);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace ncsim::toolpath
