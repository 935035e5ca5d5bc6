// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ncsim::toolpath {
namespace {

TEST(SinCos, IsExactForQuarterTurns) {
    for (int turn = -9; turn <= 9; ++turn) {
        SCOPED_TRACE(turn);
        const SinCos v = sin_cos(90.0 * turn);
        const int phase = ((turn % 4) + 4) % 4;
        EXPECT_EQ(v.sin, phase == 1 ? 1.0 : phase == 3 ? -1.0 : 0.0);
        EXPECT_EQ(v.cos, phase == 0 ? 1.0 : phase == 2 ? -1.0 : 0.0);
    }
}

TEST(SinCos, AgreesWithTheLibraryToTheLastBits) {
    for (double degrees = -720.0; degrees <= 720.0; degrees += 0.37) {
        SCOPED_TRACE(degrees);
        const long double rad =
            static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180.0L;
        const SinCos v = sin_cos(degrees);
        EXPECT_NEAR(v.sin, static_cast<double>(std::sin(rad)), 3e-16);
        EXPECT_NEAR(v.cos, static_cast<double>(std::cos(rad)), 3e-16);
    }
}

TEST(SinCos, OfUnwoundAnglesIsThatOfTheAngleItself) {
    EXPECT_EQ(sin_cos(-153720.0 - 30.0).sin, sin_cos(-30.0).sin);
    EXPECT_EQ(sin_cos(360.0 * 4096 + 12.5).cos, sin_cos(12.5).cos);
}

TEST(AngleOf, IsExactOnAxesAndDiagonals) {
    EXPECT_EQ(angle_of(0, 0), 0.0);
    EXPECT_EQ(angle_of(3, 0), 0.0);
    EXPECT_EQ(angle_of(3, 3), 45.0);
    EXPECT_EQ(angle_of(0, 3), 90.0);
    EXPECT_EQ(angle_of(-3, 0), 180.0);
    EXPECT_EQ(angle_of(-3, -3), -135.0);
    EXPECT_EQ(angle_of(0, -3), -90.0);
}

TEST(AngleOf, UndoesSinCos) {
    for (double degrees = -179.9; degrees <= 180.0; degrees += 0.173) {
        const SinCos v = sin_cos(degrees);
        EXPECT_NEAR(angle_of(v.cos, v.sin), degrees, 6e-14);
    }
}

}  // namespace
}  // namespace ncsim::toolpath
