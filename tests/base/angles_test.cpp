// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests sines, cosines, angles and lengths for exact values and against the C library.
#include "ncsim/base/angles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace ncsim {
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

TEST(SinCos, IsExactWhereMachinistsExpectIt) {
    for (int turn = -4; turn <= 4; ++turn) {
        SCOPED_TRACE(turn);
        const double at = 360.0 * turn;
        EXPECT_EQ(sin_cos(at + 30.0).sin, 0.5);
        EXPECT_EQ(sin_cos(at + 150.0).sin, 0.5);
        EXPECT_EQ(sin_cos(at - 30.0).sin, -0.5);
        EXPECT_EQ(sin_cos(at + 210.0).sin, -0.5);
        EXPECT_EQ(sin_cos(at + 60.0).cos, 0.5);
        EXPECT_EQ(sin_cos(at - 60.0).cos, 0.5);
        EXPECT_EQ(sin_cos(at + 120.0).cos, -0.5);
        EXPECT_EQ(tangent(at + 45.0), 1.0);
        EXPECT_EQ(tangent(at + 135.0), -1.0);
        EXPECT_EQ(tangent(at + 225.0), 1.0);
        EXPECT_EQ(tangent(at - 45.0), -1.0);
    }
}

TEST(SinCos, OfNoNumberIsThatOfZero) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double none : {kInfinity, -kInfinity, std::nan("")}) {
        EXPECT_EQ(sin_cos(none).sin, 0.0);
        EXPECT_EQ(sin_cos(none).cos, 1.0);
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

// After the removal of turns and quarter turns, the result is the library's result for the rest.
TEST(SinCos, TakesTurnsAwayExactly) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 200000; ++i) {
        const double whole = static_cast<double>(random() % 4000) - 2000.0;
        const double off =
            std::ldexp(static_cast<double>(random() % 64), -static_cast<int>(random() % 60));
        for (const double degrees : {45.0 * whole + off, 45.0 * whole - off, 90.0 * whole * off}) {
            const double turned = std::remainder(degrees, 360.0);
            const double rest = std::remainder(turned, 90.0);
            const int quarters = (static_cast<int>(std::nearbyint(turned / 90.0)) + 4) % 4;
            const SinCos left = sin_cos(rest);
            const SinCos v = sin_cos(degrees);
            ASSERT_EQ(v.sin, (std::array{left.sin, left.cos, -left.sin, -left.cos}[quarters]))
                << degrees;
            ASSERT_EQ(v.cos, (std::array{left.cos, -left.sin, -left.cos, left.sin}[quarters]))
                << degrees;
        }
    }
}

TEST(Rotate, TurnsCounterclockwiseAndQuartersExactly) {
    double x = 3.0;
    double y = 0.1;
    rotate(x, y, 90.0);
    EXPECT_EQ(x, -0.1);
    EXPECT_EQ(y, 3.0);
    rotate(x, y, -90.0);
    rotate(x, y, 30.0);
    EXPECT_DOUBLE_EQ(x, 3.0 * std::sqrt(0.75) - 0.05);
    EXPECT_DOUBLE_EQ(y, 1.5 + 0.1 * std::sqrt(0.75));
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

TEST(LengthOf, IsExactForWholeNumbersThatHaveOne) {
    EXPECT_EQ(hypotenuse(0.0, 0.0), 0.0);
    EXPECT_EQ(hypotenuse(-3.0, 4.0), 5.0);
    EXPECT_EQ(hypotenuse(0.0, -0.1), 0.1);
    EXPECT_EQ(hypotenuse(20e6, 21e6), 29e6);
}

TEST(LengthOf, IsFiniteWhereverTheLengthIs) {
    for (const int scale : {-1070, -600, -331, -330, 0, 500, 510, 1015}) {
        SCOPED_TRACE(scale);
        EXPECT_EQ(hypotenuse(std::ldexp(-3.0, scale), std::ldexp(4.0, scale)),
                  std::ldexp(5.0, scale));
        EXPECT_EQ(hypotenuse(0.0, std::ldexp(1.0, scale)), std::ldexp(1.0, scale));
    }
    EXPECT_EQ(hypotenuse(1.0, -std::numeric_limits<double>::infinity()),
              std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(hypotenuse(1.0, std::nan(""))));
}

}  // namespace
}  // namespace ncsim
