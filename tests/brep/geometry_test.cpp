// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small geometry that all surfaces use: the nearest point of an ellipse, common points of surfaces,
// and angles that loops cover around an axis.
#include "geometry/ellipse.h"
#include "geometry/intersection_spline.h"
#include "geometry/newton.h"
#include "topology/angular_extent.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(EllipseFoot, IsTheNearestPoint) {
    for (const auto& [a, b] :
         std::vector<std::pair<double, double>>{{5, 3}, {5, 4.9}, {8, 0.5}, {4, 4}}) {
        for (double x = -9.0; x <= 9.0; x += 1.5) {
            for (double y = -6.0; y <= 6.0; y += 1.5) {
                if (a == b && x == 0.0 && y == 0.0) continue;  // each direction is right
                double least = std::numeric_limits<double>::max();
                for (int i = 0; i < 4'000; ++i) {
                    const double t = i * 2.0 * std::numbers::pi / 4'000;
                    least = std::min(least, std::hypot(x - a * std::cos(t), y - b * std::sin(t)));
                }
                const EllipseFoot foot = foot_on_ellipse(a, b, x, y);
                const bool is_inside = x * x / (a * a) + y * y / (b * b) < 1.0;
                EXPECT_NEAR(foot.distance, is_inside ? -least : least, 2e-3)
                    << a << ' ' << b << ' ' << x << ' ' << y;
                // The foot is on the ellipse, and the normal is a unit vector outwards.
                const double px = x - foot.distance * foot.x, py = y - foot.distance * foot.y;
                EXPECT_NEAR(px * px / (a * a) + py * py / (b * b), 1.0, 1e-9);
                EXPECT_NEAR(foot.x * foot.x + foot.y * foot.y, 1.0, 1e-12);
                EXPECT_GE(foot.x * px + foot.y * py, 0.0);
            }
        }
    }
}

TEST(EllipseFoot, OnTheLongAxis) {
    // Within (a² - b²) / a = 3.2 of the centre the nearest points are aside, beyond it the vertex.
    EXPECT_NEAR(foot_on_ellipse(5, 3, 0, 0).distance, -3.0, 1e-12);
    EXPECT_NEAR(foot_on_ellipse(5, 3, 4, 0).distance, -1.0, 1e-9);
    EXPECT_NEAR(foot_on_ellipse(5, 3, 7, 0).distance, 2.0, 1e-9);
    EXPECT_NEAR(foot_on_ellipse(5, 3, -7, 0).x, -1.0, 1e-12);
    EXPECT_NEAR(foot_on_ellipse(5, 3, 0, -8).distance, 5.0, 1e-9);
    EXPECT_NEAR(foot_on_ellipse(5, 3, 0, -8).y, -1.0, 1e-12);
    // x = 1.6: the foot is at 25 * 1.6 / 16 = 2.5, y = 3 * sqrt(0.75).
    const EllipseFoot foot = foot_on_ellipse(5, 3, 1.6, 0);
    EXPECT_NEAR(foot.distance, -std::hypot(0.9, 3.0 * std::sqrt(0.75)), 1e-9);
}

TEST(Newton, FindsPointsThatFormsShare) {
    const Form floor = Plane{{0, 0, 2}, {0, 0, 1}};
    const Form wall = Plane{{3, 0, 0}, {1, 0, 0}};
    const Form ball = Sphere{{0, 0, 0}, 7.0};
    // z 2, x 3, and 49 = 9 + 4 + y²: y = ±6.
    const std::array<const Form*, 3> forms{&floor, &wall, &ball};
    for (const double side : {6.0, -6.0}) {
        Vec3 p{2.5, 0.9 * side, 2.5};
        EXPECT_LT(solve(forms, p), 1e-9);
        EXPECT_NEAR(p.x, 3.0, 1e-9);
        EXPECT_NEAR(p.y, side, 1e-9);
        EXPECT_NEAR(p.z, 2.0, 1e-9);
    }
    // Two planes: the nearest point of their line.
    const std::array<const Form*, 2> planes{&floor, &wall};
    Vec3 near{1, 5, 9};
    EXPECT_LT(solve(planes, near), 1e-9);
    EXPECT_NEAR(near.x, 3.0, 1e-9);
    EXPECT_NEAR(near.y, 5.0, 1e-9);
    EXPECT_NEAR(near.z, 2.0, 1e-9);
    // Parallel planes 3 mm apart have no common point: half of the distance stays.
    const Form above = Plane{{0, 0, 5}, {0, 0, 1}};
    const std::array<const Form*, 2> parallel{&floor, &above};
    Vec3 between{0, 0, 3};
    EXPECT_NEAR(solve(parallel, between), 1.5, 1e-6);
}

std::vector<Vec3> arc(double from, double to, double radius, double z) {
    std::vector<Vec3> points;
    const int steps = std::max(1, static_cast<int>(std::abs(to - from) / 10.0));
    for (int i = 0; i <= steps; ++i) {
        const double a = (from + (to - from) * i / steps) * kDegree;
        points.push_back({radius * std::cos(a), radius * std::sin(a), z});
    }
    return points;
}

// Readers measure at both ends and at equal steps between; whatever deviates more, they doubt.
// Their cuts may fail where edges are off their surfaces along their length.
TEST(ArcSpline, DeviatesMostAtItsEnds) {
    constexpr int kPlaces = 997;
    const Vec3 x{0.6, 0.0, 0.8}, y{0.0, 1.0, 0.0}, axis = cross(x, y);
    for (const double radius : {0.05, 1.0, 20.0, 400.0}) {
        for (const double sweep : {3.0, 95.0, 181.0, 350.0}) {
            for (const auto& [first, last] : {std::array{2e-7, 2e-7}, std::array{-2e-7, 1e-3},
                                              std::array{1e-4, 0.0}, std::array{0.0, -3e-6}}) {
                const Circle circle{{1.0, 2.0, 3.0}, axis, radius};
                const auto place = [&](double degrees, double off) {
                    const double a = degrees * std::numbers::pi / 180.0;
                    return circle.centre + (radius + off) * (std::cos(a) * x + std::sin(a) * y);
                };
                const Vec3 from = place(10.0, first), to = place(10.0 + sweep, last);
                const Curve curve = arc_spline(circle, from, to);
                const Track track(curve, from, to);
                SCOPED_TRACE(testing::Message() << radius << ' ' << sweep << ' ' << last);
                EXPECT_EQ(track.at(0.0), from);
                EXPECT_EQ(track.at(1.0), to);
                const auto off = [&](double t) {
                    const Vec3 v = track.at(t) - circle.centre;
                    EXPECT_NEAR(dot(v, axis), 0.0, 1e-12 * radius + 1e-13);
                    return std::abs(norm(v) - radius);
                };
                const double most = std::max(std::abs(first), std::abs(last));
                for (int i = 0; i <= kPlaces; ++i) {
                    const double t = static_cast<double>(i) / kPlaces;
                    EXPECT_LE(off(t), most + 1e-12) << t;
                }
                EXPECT_LT(off(0.35), 2e-9 + 3e-3 * most);
                EXPECT_LT(off(0.65), 2e-9 + 3e-3 * most);
                // No piece leaves the direction of the circle, unless the arc is too short.
                const bool is_long = radius * sweep * std::numbers::pi / 180.0 > 300.0 * most;
                for (int i = 0; is_long && i <= kPlaces; ++i) {
                    const double t = static_cast<double>(i) / kPlaces;
                    const Vec3 out = normalized(track.at(t) - circle.centre);
                    EXPECT_LT(std::abs(dot(normalized(track.derivative(t)), out)), 0.025) << t;
                }
                // The arc goes the whole way, evenly.
                const Vec3 half = track.at(0.5) - circle.centre;
                EXPECT_LT(norm(half - (place(10.0 + 0.5 * sweep, 0.0) - circle.centre)),
                          1e-6 * radius + most);
            }
        }
    }
}

TEST(AngularExtent, HasTheWidestGap) {
    const Vec3 origin{}, axis{0, 0, 1}, x{1, 0, 0};
    const auto of = [&](const std::vector<std::vector<Vec3>>& loops) {
        return angular_extent(loops, origin, axis, x);
    };
    // A patch from 30 to 80 degrees, there and back.
    std::vector<Vec3> patch = arc(30, 80, 5, 0);
    const std::vector<Vec3> back = arc(80, 30, 5, 4);
    patch.insert(patch.end(), back.begin(), back.end());
    const AngularExtent one = of({patch});
    EXPECT_NEAR(one.gap_begin, 80.0, 1e-9);
    EXPECT_NEAR(one.gap, 310.0, 1e-9);
    EXPECT_FALSE(one.is_full_turn);
    EXPECT_NEAR(one.sum, 0.0, 1e-9);
    EXPECT_NEAR(one.nearest, 5.0 / std::hypot(5.0, 4.0), 1e-12);
    // Across the start of angles: from -20 to 50.
    std::vector<Vec3> across = arc(-20, 50, 5, 0);
    const std::vector<Vec3> home = arc(50, -20, 5, 4);
    across.insert(across.end(), home.begin(), home.end());
    EXPECT_NEAR(of({across}).gap_begin, 50.0, 1e-9);
    EXPECT_NEAR(of({across}).gap, 290.0, 1e-9);
    // Two patches: the wider gap counts.
    const AngularExtent two = of({arc(0, 90, 5, 0), arc(200, 260, 5, 0)});
    EXPECT_NEAR(two.gap, 110.0, 1e-9);
    EXPECT_NEAR(two.gap_begin, 90.0, 1e-9);
}

TEST(AngularExtent, OfAFullTurn) {
    const Vec3 origin{1, 2, 3}, axis{0, 0, 1}, x{1, 0, 0};
    std::vector<Vec3> circle = arc(0, 350, 5, 0);
    for (Vec3& p : circle)
        p = p + origin;
    const AngularExtent turn = angular_extent({circle}, origin, axis, x);
    EXPECT_TRUE(turn.is_full_turn);
    EXPECT_NEAR(turn.sum, 360.0, 1e-9);
    EXPECT_NEAR(turn.gap, 0.0, 1e-9);
    EXPECT_NEAR(turn.nearest, 1.0, 1e-12);
    std::vector<Vec3> clockwise(circle.rbegin(), circle.rend());
    EXPECT_NEAR(angular_extent({clockwise}, origin, axis, x).sum, -360.0, 1e-9);
    EXPECT_NEAR(angular_extent({circle, clockwise}, origin, axis, x).sum, 0.0, 1e-9);
    // A point on the axis has no angle.
    EXPECT_EQ(angular_extent({{origin}}, origin, axis, x).gap, 0.0);
}

TEST(WindingAngle, CountsTurnsWithTheirSign) {
    const Vec3 centre{}, axis{0, 0, 1};
    EXPECT_NEAR(winding_angle(arc(10, 100, 2, 0), centre, axis), 90.0, 1e-9);
    EXPECT_NEAR(winding_angle(arc(100, 10, 2, 0), centre, axis), -90.0, 1e-9);
    EXPECT_NEAR(winding_angle(arc(0, 800, 2, 0), centre, axis), 800.0, 1e-9);
    EXPECT_NEAR(winding_angle(arc(0, 800, 2, 0), centre, {0, 0, -1}), -800.0, 1e-9);
    EXPECT_EQ(winding_angle({}, centre, axis), 0.0);
}

}  // namespace
}  // namespace ncsim::brep
