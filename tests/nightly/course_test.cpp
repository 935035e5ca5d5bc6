// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/course.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::nightly {
namespace {

Vec where(const Course& course, double t) {
    return course.to_workpiece(t, {});
}

void expect_near(const Vec& a, const Vec& b, double tolerance = 1e-12) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance);
}

TEST(Course, StraightIsHalfWayInTheMiddle) {
    const Course course = Course::straight({{0, 0, 5}, {}}, {{10, -4, 5}, {}});
    expect_near(where(course, 0.5), {5, -2, 5});
}

TEST(Course, CounterClockwiseIsSeenFromTheThirdAxis) {
    // A quarter about the origin from the first axis to the second: G3 in G17, G18, G19.
    const double c = std::sqrt(0.5);
    expect_near(where(Course::arc({{1, 0, 0}, {}}, {{0, 1, 0}, {}}, 0, 1, {}, true, 0), 0.5),
                {c, c, 0});
    expect_near(where(Course::arc({{0, 0, 1}, {}}, {{1, 0, 0}, {}}, 2, 0, {}, true, 0), 0.5),
                {c, 0, c});
    expect_near(where(Course::arc({{0, 1, 0}, {}}, {{0, 0, 1}, {}}, 1, 2, {}, true, 0), 0.5),
                {0, c, c});
    // Three quarters in the opposite direction.
    expect_near(where(Course::arc({{1, 0, 0}, {}}, {{0, 1, 0}, {}}, 0, 1, {}, false, 0), 0.5),
                {-c, -c, 0});
}

TEST(Course, EqualEndsAreAFullTurnAndHelicesKeepStep) {
    const Course course = Course::arc({{3, 0, 0}, {}}, {{3, 0, -4}, {}}, 0, 1, {1, 0}, false, 1);
    EXPECT_NEAR(course.circling()->sweep, -4 * std::numbers::pi, 1e-12);
    expect_near(where(course, 0.25), {-1, 0, -1});
    expect_near(where(course, 0.375), {1, 2, -1.5});
}

TEST(Course, TurnsAboutTheAxesOfTheWorkpieceAFirst) {
    const Course course = Course::straight({{1, 2, 3}, {90, 0, 0}}, {{1, 2, 3}, {90, 90, 90}});
    // Rx(90): (x, -z, y); then Ry(90): (z, y, -x); then Rz(90): (-y, x, z).
    expect_near(where(course, 0.0), {1, -3, 2});
    expect_near(where(course, 1.0), {3, 2, -1});
}

TEST(Course, TwistIsHowATurnedToolStandsOtherThanByTheLeastRotation) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const auto twist = [](Vec turn) { return Course::straight({{}, turn}, {{}, turn}).twist(0.0); };
    EXPECT_NEAR(twist({0, 0, 30}), 30 * kDegree, 1e-12);
    EXPECT_NEAR(twist({40, 0, 0}), 0.0, 1e-12);
    EXPECT_NEAR(twist({0, -50, 0}), 0.0, 1e-12);
    EXPECT_NEAR(std::cos(twist({90, 90, 0})), 0.0, 1e-12);
}

TEST(Course, ToTheToolAndBackIsWhereItWas) {
    const Course course =
        Course::arc({{5, 1, 0}, {10, 20, 30}}, {{-3, 4, 2}, {-40, 0, 90}}, 0, 1, {1, 1}, true, 0);
    for (const double t : {0.0, 0.3, 1.0}) {
        const Vec p{3, -7, 11};
        expect_near(course.to_workpiece(t, course.to_tool(t, p)), p);
    }
}

TEST(Course, BendsNoMoreThanItSays) {
    test::Random random(1);
    for (int i = 0; i < 300; ++i) {
        const auto somewhere = [&](double reach) {
            return Vec{random.within(-reach, reach), random.within(-reach, reach),
                       random.within(-reach, reach)};
        };
        const Axes from{somewhere(10), random.one_in(3) ? Vec{} : somewhere(60)};
        const Axes to{somewhere(10), random.one_in(3) ? from.turn : somewhere(60)};
        const Course course =
            random.one_in(2)
                ? Course::straight(from, to)
                : Course::arc(from, to, 0, 1, {random.unit(), random.unit()}, random.one_in(2), 0);
        const Vec p = somewhere(20);
        const double most = course.bend(p);
        constexpr double kStep = 1e-3;
        double found = 0.0;
        for (double t = kStep; t < 1 - kStep; t += kStep) {
            const Vec second = course.to_tool(t - kStep, p) - 2.0 * course.to_tool(t, p) +
                               course.to_tool(t + kStep, p);
            found = std::max(found, norm(second) / (kStep * kStep));
        }
        ASSERT_LE(found, most * (1 + 1e-6) + 1e-4);
    }
}

}  // namespace
}  // namespace ncsim::nightly
