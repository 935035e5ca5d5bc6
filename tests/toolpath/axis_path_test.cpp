// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions along arcs and splines, against circles on paper, Bézier curves and the recursion that
// defines B-splines.
#include "motion/axis_path.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

constexpr double kPi = std::numbers::pi;

Position place(double x, double y, double z) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Arc arc(const Position& from, const Position& to, int turns = 1) {
    gcode::Arc made;
    made.from = from, made.to = to, made.turns = turns;
    return made;
}

TEST(PolarArc, SweepsInTheDirectionOfItsTurns) {
    const auto sweep = [](double degrees, int turns) {
        const double a = degrees * kPi / 180.0;
        return polar(arc(place(10, 0, 0), place(10 * std::cos(a), 10 * std::sin(a), 0), turns))
            .sweep_degrees;
    };
    EXPECT_NEAR(sweep(90, 1), 90, 1e-5);
    EXPECT_NEAR(sweep(-90, 1), 270, 1e-5);
    EXPECT_NEAR(sweep(90, -1), -270, 1e-5);
    EXPECT_NEAR(sweep(-90, -1), -90, 1e-5);
    EXPECT_EQ(sweep(0, 1), 360) << "equal ends are a full circle";
    EXPECT_EQ(sweep(0, -1), -360);
    EXPECT_NEAR(sweep(90, 3), 90 + 720, 1e-5);
    EXPECT_NEAR(sweep(90, -3), -270 - 720, 1e-5);
    EXPECT_NEAR(sweep(90, 0), 90, 1e-5);
}

TEST(ArcPosition, IsOnTheSpiralWithAllAxesInProportion) {
    gcode::Arc made = arc(place(11, 2, 0), place(1, 22, 8));
    made.centre_1 = Length::from_mm(1), made.centre_2 = Length::from_mm(2);
    made.to.a = Angle::from_degrees(40);
    made.to.w = Length::from_mm(4);
    const PolarArc p = polar(made);
    EXPECT_NEAR(p.start_radius, 10, 1e-9);
    EXPECT_NEAR(p.end_radius, 20, 1e-9);
    EXPECT_EQ(arc_position(made, p, 0.0), made.from);
    EXPECT_EQ(arc_position(made, p, 1.0), made.to);
    const Position half = arc_position(made, p, 0.5);
    EXPECT_NEAR(half.x.mm(), 1 + 15 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(half.y.mm(), 2 + 15 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(half.z.mm(), 4, 1e-6);
    EXPECT_NEAR(half.a.degrees(), 20, 1e-9);
    EXPECT_NEAR(half.w.mm(), 2, 1e-6);
}

TEST(ArcPosition, HasTheAxesOfEachPlaneInOrder) {
    struct Axis {
        gcode::Plane plane;
        Length Position::*first;
        Length Position::*second;
    };
    for (const Axis& axis : {Axis{gcode::Plane::XY, &Position::x, &Position::y},
                             Axis{gcode::Plane::ZX, &Position::z, &Position::x},
                             Axis{gcode::Plane::YZ, &Position::y, &Position::z},
                             Axis{gcode::Plane::UV, &Position::u, &Position::v},
                             Axis{gcode::Plane::WU, &Position::w, &Position::u},
                             Axis{gcode::Plane::VW, &Position::v, &Position::w}}) {
        gcode::Arc made;
        made.plane = axis.plane;
        made.from.*axis.first = Length::from_mm(10);
        made.to.*axis.second = Length::from_mm(10);
        const Position half = arc_position(made, polar(made), 1.0 / 3.0);
        EXPECT_NEAR((half.*axis.first).mm(), 10 * std::sqrt(0.75), 1e-6);
        EXPECT_NEAR((half.*axis.second).mm(), 5, 1e-6);
    }
}

// A frame that leans by 30 degrees about X, with its origin off zero.
TEST(ArcPosition, OfATiltedPlaneIsOnItsCircleInTheFrame) {
    const double c = std::sqrt(0.75), s = 0.5;
    gcode::FeatureFrame frame;
    frame.origin = {3, 4, 5};
    frame.rows = {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
    gcode::Arc made;
    made.tilted = frame;
    made.from = gcode::to_parent(frame, place(10, 0, 2));
    made.to = gcode::to_parent(frame, place(0, 10, 2));
    const PolarArc p = polar(made);
    EXPECT_NEAR(p.sweep_degrees, 90, 1e-5);
    EXPECT_NEAR(p.start_radius, 10, 1e-6);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Position at = arc_position(made, p, t);
        const double u = 10 * std::cos(t * kPi / 2), v = 10 * std::sin(t * kPi / 2);
        EXPECT_NEAR(at.x.mm(), 3 + u, 1e-6) << t;
        EXPECT_NEAR(at.y.mm(), 4 + c * v - s * 2, 1e-6) << t;
        EXPECT_NEAR(at.z.mm(), 5 + s * v + c * 2, 1e-6) << t;
    }
}

TEST(SecondAxes, AreBoundedByTheirEndsOrByTheirArc) {
    const machine::Chain none;
    gcode::Motion motion;
    Position from, to;
    from.u = Length::from_mm(-3), to.u = Length::from_mm(1), to.w = Length::from_mm(2);
    motion.action = gcode::Linear{from, to};
    const SecondAxes line = second_axes(none, motion);
    EXPECT_NEAR(line.reach_mm, 3 + 2, 1e-9);
    EXPECT_NEAR(line.way_mm, 4 + 2, 1e-9);
    EXPECT_FALSE(line.along_tool);
    Position up;
    up.w = Length::from_mm(2);
    motion.action = gcode::Linear{Position{}, up};
    EXPECT_TRUE(second_axes(none, motion).along_tool);
    // The true way of a spiral in U and V from radius 10 to 20 is at most its bound, and not much
    // less.
    gcode::Arc made;
    made.plane = gcode::Plane::UV;
    made.from.u = Length::from_mm(10);
    made.to.v = Length::from_mm(20);
    motion.action = made;
    const SecondAxes spiral = second_axes(none, motion);
    const PolarArc p = polar(made);
    double way = 0.0, reach = 0.0;
    Position last = made.from;
    for (int i = 1; i <= 1000; ++i) {
        const Position at = arc_position(made, p, i / 1000.0);
        way += std::abs((at.u - last.u).mm()) + std::abs((at.v - last.v).mm());
        reach = std::max(reach, std::hypot(at.u.mm(), at.v.mm()));
        last = at;
    }
    EXPECT_GE(spiral.way_mm, way);
    EXPECT_LE(spiral.way_mm, 30 + 2 * (20 * kPi / 2 + 10) + 1e-6);
    EXPECT_GE(spiral.way_mm, 30 + 2 * (20 * kPi / 2 + 10) - 1e-6);
    EXPECT_GE(spiral.reach_mm, reach);
    EXPECT_FALSE(spiral.along_tool);
    motion.action = gcode::Dwell{1.0};
    EXPECT_EQ(second_axes(none, motion).reach_mm, 0.0);
}

// Value of the basis function N of `degree` number `i`, by the recursion of Cox and de Boor.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
    if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1.0 : 0.0;
    const auto d = static_cast<std::size_t>(degree);
    double sum = 0.0;
    if (knots[i + d] > knots[i])
        sum += (u - knots[i]) / (knots[i + d] - knots[i]) * basis(knots, i, degree - 1, u);
    if (knots[i + d + 1] > knots[i + 1]) {
        sum += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) *
               basis(knots, i + 1, degree - 1, u);
    }
    return sum;
}

TEST(SplineCurve, IsTheWeightedSumOfItsBasisFunctions) {
    test::Random random(3);
    for (int round = 0; round < 60; ++round) {
        gcode::Spline spline;
        spline.order = static_cast<int>(random.between(2, 5));
        const auto order = static_cast<std::size_t>(spline.order);
        const std::size_t count = order + static_cast<std::size_t>(random.between(0, 4));
        double knot = 0.0;
        for (std::size_t i = 0; i < count + order; ++i) {
            if (i >= order && i <= count) knot += static_cast<double>(random.between(1, 3));
            spline.knots.push_back(knot);
        }
        for (std::size_t i = 0; i < count; ++i) {
            spline.control_points.push_back({Length::from_mm(random.within(-50, 50)),
                                             Length::from_mm(random.within(-50, 50)),
                                             random.within(0.5, 2.0)});
        }
        spline.from =
            place(spline.control_points.front().x.mm(), spline.control_points.front().y.mm(), 0);
        spline.to =
            place(spline.control_points.back().x.mm(), spline.control_points.back().y.mm(), 9);
        const SplineCurve curve(spline);
        ASSERT_TRUE(curve.is_sound());
        EXPECT_EQ(curve.at(curve.first()), spline.from);
        EXPECT_EQ(curve.at(curve.last()), spline.to);
        EXPECT_EQ(curve.breaks().size(), count - order + 2);
        for (int k = 1; k < 20; ++k) {
            const double u = curve.first() + (curve.last() - curve.first()) * k / 20.0;
            double x = 0.0, y = 0.0, w = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const double n =
                    basis(spline.knots, i, spline.order - 1, u) * spline.control_points[i].weight;
                x += n * spline.control_points[i].x.mm();
                y += n * spline.control_points[i].y.mm();
                w += n;
            }
            const Position at = curve.at(u);
            EXPECT_NEAR(at.x.mm(), x / w, 1e-6);
            EXPECT_NEAR(at.y.mm(), y / w, 1e-6);
            EXPECT_NEAR(at.z.mm(), 9 * k / 20.0, 1e-6);
        }
    }
}

TEST(SplineCurve, IsSoundWithEnoughPointsAndRisingKnots) {
    gcode::Spline good;
    good.order = 3;
    good.knots = {0, 0, 0, 1, 1, 1};
    good.control_points.resize(3);
    EXPECT_TRUE(SplineCurve(good).is_sound());
    gcode::Spline bad = good;
    bad.order = 1;
    EXPECT_FALSE(SplineCurve(bad).is_sound()) << "degree 0";
    bad = good;
    bad.control_points.resize(2);
    EXPECT_FALSE(SplineCurve(bad).is_sound());
    bad = good;
    bad.knots.push_back(1);
    EXPECT_FALSE(SplineCurve(bad).is_sound());
    bad = good;
    bad.knots = {0, 0, 0, 1, 0.5, 1};
    EXPECT_FALSE(SplineCurve(bad).is_sound());
    bad = good;
    bad.knots = {0, 0, 1, 1, 1, 1};
    EXPECT_FALSE(SplineCurve(bad).is_sound()) << "no range";
}

}  // namespace
}  // namespace ncsim::toolpath
