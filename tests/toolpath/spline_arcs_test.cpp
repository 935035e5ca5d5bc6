// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/spline_arcs.h"

#include "ncsim/base/angles.h"

#include "motion/axis_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Length;
using gcode::Spline;

Spline spline_of(const std::vector<std::array<double, 3>>& points, int order,
                 std::vector<double> knots) {
    Spline spline;
    spline.order = order;
    spline.knots = std::move(knots);
    for (const auto& [x, y, weight] : points)
        spline.control_points.push_back({Length::from_mm(x), Length::from_mm(y), weight});
    spline.from.x = spline.control_points.front().x;
    spline.from.y = spline.control_points.front().y;
    spline.to.x = spline.control_points.back().x;
    spline.to.y = spline.control_points.back().y;
    return spline;
}

Vec3 at(const SplinePiece& piece, double t) {
    if (!(piece.radius > 0.0)) return piece.from + t * (piece.to - piece.from);
    const auto angle = sin_cos(t * piece.swept_degrees);
    const Vec3 out = piece.from - piece.centre;
    return piece.centre + angle.cos * out + angle.sin * Vec3{-out.y, out.x, 0.0};
}

// Returns the largest distance from a point of the pieces to the nearest of many points of the
// curve.
double farthest(const Spline& spline, const std::vector<SplinePiece>& pieces) {
    const SplineCurve curve(spline);
    constexpr int kPoints = 4000, kOfPiece = 20;
    std::vector<Vec3> points;
    for (int i = 0; i <= kPoints; ++i)
        points.push_back(
            linear_axes(curve.at(curve.first() + i * (curve.last() - curve.first()) / kPoints)));
    double most = 0.0;
    for (const SplinePiece& piece : pieces) {
        for (int i = 0; i <= kOfPiece; ++i) {
            const Vec3 p = at(piece, static_cast<double>(i) / kOfPiece);
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t k = 1; k < points.size(); ++k) {
                const Vec3 along = points[k] - points[k - 1];
                const double t =
                    std::clamp(dot(p - points[k - 1], along) / dot(along, along), 0.0, 1.0);
                least = std::min(least, norm(p - points[k - 1] - t * along));
            }
            most = std::max(most, least);
        }
    }
    return most;
}

TEST(SplineArcs, GoOnInOneDirectionNearTheCurve) {
    const Spline s_curve = spline_of({{10, 20, 1}, {40, 20, 1}, {30, 40, 1}, {60, 40, 1}}, 4,
                                     {0, 0, 0, 0, 1, 1, 1, 1});
    std::size_t before = 0;
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        SCOPED_TRACE(tolerance);
        const auto pieces = arcs_of(s_curve, tolerance);
        EXPECT_GT(pieces.size(), before);
        EXPECT_LT(pieces.size(), 64U);
        before = pieces.size();
        EXPECT_LT(farthest(s_curve, pieces), 1.2 * tolerance);
        EXPECT_EQ(pieces.front().from, (Vec3{10, 20, 0}));
        EXPECT_EQ(pieces.back().to, (Vec3{60, 40, 0}));
        EXPECT_TRUE(pieces.front().begins_in_corner);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_LT(norm(at(pieces[i], 1.0) - pieces[i].to), 1e-9);
            if (i == 0) continue;
            EXPECT_EQ(pieces[i].from, pieces[i - 1].to);
            EXPECT_FALSE(pieces[i].begins_in_corner);
        }
    }
}

// A curve that is scaled with its tolerance has as many pieces, which are scaled likewise.
TEST(SplineArcs, AreScaledWithTheCurve) {
    const std::vector<std::array<double, 3>> points{{0, 0, 1},   {10, 30, 1}, {25, -20, 1},
                                                    {30, 40, 1}, {45, 10, 1}, {38, -9, 1}};
    const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    const auto whole = arcs_of(spline_of(points, 4, knots), 0.01);
    ASSERT_GT(whole.size(), 10U);
    for (const double scale : {0.001, 0.03, 20.0}) {
        auto scaled = points;
        for (auto& [x, y, weight] : scaled)
            x *= scale, y *= scale;
        const auto pieces = arcs_of(spline_of(scaled, 4, knots), 0.01 * scale);
        ASSERT_EQ(pieces.size(), whole.size()) << scale;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_LT(norm(pieces[i].to - scale * whole[i].to), 1e-6 * scale);
            EXPECT_NEAR(pieces[i].radius, scale * whole[i].radius, 1e-6 * scale * whole[i].radius);
            EXPECT_NEAR(pieces[i].swept_degrees, whole[i].swept_degrees, 1e-5);
        }
    }
}

// A quarter circle as a rational spline is a quarter circle, in two arcs.
TEST(SplineArcs, OfACircleAreTheCircle) {
    const Spline quarter =
        spline_of({{5, 0, 1}, {5, 5, std::sqrt(0.5)}, {0, 5, 1}}, 3, {0, 0, 0, 1, 1, 1});
    const auto pieces = arcs_of(quarter, 1e-3);
    ASSERT_EQ(pieces.size(), 2U);
    for (const SplinePiece& piece : pieces) {
        EXPECT_NEAR(piece.radius, 5.0, 1e-9);
        EXPECT_LT(norm(piece.centre), 1e-9);
        EXPECT_NEAR(piece.swept_degrees, 45.0, 1e-7);
    }
}

// A multiple knot makes a corner; straight spans become lines.
TEST(SplineArcs, HaveLinesAndCorners) {
    const Spline angle = spline_of({{0, 0, 1}, {10, 0, 1}, {10, 10, 1}}, 2, {0, 0, 1, 2, 2});
    const auto pieces = arcs_of(angle, 1e-3);
    ASSERT_EQ(pieces.size(), 4U);
    for (const SplinePiece& piece : pieces)
        EXPECT_EQ(piece.radius, 0.0);
    EXPECT_FALSE(pieces[1].begins_in_corner);
    EXPECT_TRUE(pieces[2].begins_in_corner);
    EXPECT_FALSE(pieces[3].begins_in_corner);
}

TEST(SplineArcs, AreNoneOfWhatIsNoSpline) {
    EXPECT_TRUE(arcs_of({}, 1e-3).empty());
    const Spline still = spline_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 3, {0, 0, 0, 1, 1, 1});
    EXPECT_TRUE(arcs_of(still, 1e-3).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Spline lost = spline_of({{0, 0, 1}, {nan, 5, 1}, {9, 9, 1}}, 3, {0, 0, 0, 1, 1, 1});
    EXPECT_TRUE(arcs_of(lost, 1e-3).empty());
}

}  // namespace
}  // namespace ncsim::toolpath
