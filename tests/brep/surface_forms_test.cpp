// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests distances, gradients and parameters of extrusions, domes, coils and spirals.
#include "ncsim/brep/surface_forms.h"

#include "brep/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ncsim::brep {
namespace {

using test::Draw;

Extrusion random_extrusion(Draw& draw) {
    Extrusion e{{draw.from(-9, 9), draw.from(-9, 9), draw.from(-9, 9)}, draw.direction(), {}, 0.0};
    do
        e.along = draw.direction();
    while (std::abs(dot(e.axis, e.along)) < 0.02 || std::abs(dot(e.axis, e.along)) > 0.999);
    if (dot(e.axis, e.along) < 0.0) e.along = -e.along;
    e.radius = draw.from(0.5, 10.0);
    return e;
}

// Returns the surface point at `angle` (rad) of the circle, moved by `far` (mm) along the line.
Vec3 point_of(const Extrusion& e, double angle, double far) {
    const Vec3 x = any_perpendicular(e.axis), y = cross(e.axis, x);
    return e.centre + (e.radius * std::cos(angle)) * x + (e.radius * std::sin(angle)) * y +
           far * e.along;
}

TEST(Extrusion, IsAsFarAsTheNearestOfItsRulings) {
    Draw draw(7);
    for (int i = 0; i < 200; ++i) {
        const Extrusion e = random_extrusion(draw);
        const Vec3 p = e.centre + Vec3{draw.from(-15, 15), draw.from(-15, 15), draw.from(-15, 15)};
        double nearest = std::numeric_limits<double>::infinity();
        constexpr int kRulings = 20000;
        for (int k = 0; k < kRulings; ++k) {
            const Vec3 v = p - point_of(e, 2.0 * std::numbers::pi * k / kRulings, 0.0);
            nearest = std::min(nearest, norm(v - dot(v, e.along) * e.along));
        }
        const Vec3 level = p - place_along(e, p) * e.along - e.centre;
        const double sign = norm(level) < e.radius ? -1.0 : 1.0;
        EXPECT_NEAR(distance(e, p), sign * nearest, 2e-3);
        // Moving against the gradient by the distance ends on the surface.
        const Vec3 foot = p - distance(e, p) * gradient(e, p);
        EXPECT_NEAR(distance(e, foot), 0.0, 1e-9);
    }
}

TEST(Extrusion, HasItsNormalsAndPlaces) {
    Draw draw(7);
    for (int i = 0; i < 1000; ++i) {
        const Extrusion e = random_extrusion(draw);
        const double angle = draw.from(0.0, 6.2), far = draw.from(-20, 20);
        const Vec3 p = point_of(e, angle, far), n = gradient(e, p);
        EXPECT_NEAR(distance(e, p), 0.0, 1e-11);
        EXPECT_NEAR(place_along(e, p), far, 1e-9);
        EXPECT_NEAR(norm(n), 1.0, 1e-12);
        EXPECT_NEAR(dot(n, e.along), 0.0, 1e-12);
        const Vec3 out = p - far * e.along - e.centre;
        // Rulings of a flat extrusion are thousands of times nearer to each other at its bend.
        EXPECT_NEAR(dot(n, cross(e.axis, normalized(out))), 0.0, 1e-6);
        EXPECT_GT(dot(n, out), 0.0);
    }
    const Extrusion flat{{1, 2, 3}, {0, 0, 1}, {0.6, 0, 0.8}, 5.0};
    // In the middle, on the long axis and beyond the axis.
    EXPECT_NEAR(distance(flat, flat.centre), -4.0, 1e-12);
    EXPECT_NEAR(distance(flat, flat.centre + Vec3{0, 5, 0}), 0.0, 1e-12);
    EXPECT_NEAR(distance(flat, flat.centre + Vec3{0, 7, 0}), 2.0, 1e-12);
    EXPECT_NEAR(distance(flat, flat.centre + Vec3{0, 1.8, 0}), -3.2, 1e-12);
}

TEST(Extrusion, IsTheSameWhereverItsCircleIs) {
    const Extrusion e{{1, 2, 3}, {0, 0, 1}, {0.6, 0, 0.8}, 5.0};
    Extrusion moved = e;
    moved.centre = e.centre + 7.0 * e.along;
    EXPECT_TRUE(is_same({e, true}, {moved, true}, 1e-9));
    EXPECT_FALSE(is_same({e, true}, {moved, false}, 1e-9));
    moved.centre = e.centre + Vec3{0, 0, 1e-3};
    EXPECT_FALSE(is_same({e, true}, {moved, true}, 5e-4));
    EXPECT_TRUE(is_same({e, true}, {moved, true}, 1e-3));
    moved = e;
    moved.along = normalized({0.6, 0.01, 0.8});
    EXPECT_FALSE(is_same({e, true}, {moved, true}, 1e-3));
}

// Sets the centre, the axis and the start direction around the axis at random.
template <class Surface>
void put_anywhere(Surface& surface, Draw& draw) {
    surface.centre = {draw.from(-9, 9), draw.from(-9, 9), draw.from(-9, 9)};
    surface.axis = draw.direction();
    const double turn = draw.from(0.0, 6.2);
    const Vec3 x = any_perpendicular(surface.axis);
    surface.ahead = std::cos(turn) * x + std::sin(turn) * cross(surface.axis, x);
}

Dome random_dome(Draw& draw) {
    Dome dome;
    put_anywhere(dome, draw);
    dome.reach = draw.from(0.2, 9.0);
    dome.radius = draw.from(0.5, 9.0);
    return dome;
}

// Returns the point at the angles `arc` of the arc and `circle` of the circle from `ahead`, in rad.
Vec3 point_of(const Dome& d, double arc, double circle) {
    return d.centre + (d.reach * std::cos(arc) + d.radius * std::cos(circle)) * d.ahead +
           d.reach * std::sin(arc) * d.axis + d.radius * std::sin(circle) * cross(d.axis, d.ahead);
}

TEST(Dome, HasItsPlacesNormalsAndDistances) {
    Draw draw(7);
    for (int i = 0; i < 2000; ++i) {
        const Dome dome = random_dome(draw);
        const double arc = draw.from(-1.5, 1.5), circle = draw.from(0.0, 6.28);
        const Vec3 p = point_of(dome, arc, circle);
        // The side points of the dome's ends have no normal, and the dome bends sharply near them.
        if (std::abs(std::cos(circle)) + std::cos(arc) < 0.3) continue;
        constexpr double kStep = 1e-6;
        const Vec3 u = point_of(dome, arc, circle + kStep) - point_of(dome, arc, circle - kStep);
        const Vec3 v = point_of(dome, arc + kStep, circle) - point_of(dome, arc - kStep, circle);
        const Vec3 n = normalized(cross(u, v));
        EXPECT_NEAR(distance(dome, p), 0.0, 1e-11);
        EXPECT_NEAR(norm(gradient(dome, p) - n), 0.0, 1e-7);
        EXPECT_NEAR(project_onto(dome, p).degrees(), arc * 180.0 / std::numbers::pi, 1e-6);
        // The distance is smaller than the radii of curvature.
        const double deviation = draw.from(-0.03, 0.03) * std::min(dome.reach, dome.radius);
        EXPECT_NEAR(distance(dome, p + deviation * n), deviation, 1e-6);
    }
}

TEST(Dome, IsTheSameOnOneSideOnly) {
    const Dome dome{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, 6.0, 5.0};
    Dome other = dome;
    other.centre.z += 1e-4;
    EXPECT_TRUE(is_same({dome, true}, {other, true}, 1e-3));
    EXPECT_FALSE(is_same({dome, true}, {other, true}, 1e-5));
    other = dome;
    other.ahead = -other.ahead;
    EXPECT_FALSE(is_same({dome, true}, {other, true}, 1e-3));
}

Coil random_coil(Draw& draw) {
    Coil coil;
    put_anywhere(coil, draw);
    coil.reach = draw.from(0.2, 9.0);
    coil.radius = draw.from(0.5, 9.0);
    coil.lead = draw.from(0.1, 1.0) * (draw.from(-1, 1) < 0.0 ? -1.0 : 1.0);
    return coil;
}

// Returns the point at the angles `helix` of the helix and `circle` of the circle from its
// direction of motion, in rad.
Vec3 point_of(const Coil& c, double helix, double circle) {
    const Vec3 side = cross(c.axis, c.ahead);
    const Vec3 up = std::cos(helix) * c.ahead + std::sin(helix) * side;
    const Vec3 way = cross(c.axis, up);
    return c.centre + c.reach * up + c.lead * helix * c.axis +
           c.radius * (std::cos(circle) * way - std::sin(circle) * up);
}

TEST(Coil, HasItsPlacesNormalsAndDistances) {
    Draw draw(7);
    for (int i = 0; i < 2000; ++i) {
        const Coil coil = random_coil(draw);
        // A point on the rear half, up to two turns up or down.
        const double helix = draw.from(-12.0, 12.0), circle = draw.from(1.7, 4.6);
        const Vec3 p = point_of(coil, helix, circle);
        constexpr double kStep = 1e-6;
        const Vec3 u =
            point_of(coil, helix, circle + kStep) - point_of(coil, helix, circle - kStep);
        const Vec3 v =
            point_of(coil, helix + kStep, circle) - point_of(coil, helix - kStep, circle);
        // The normal points out of the circle: up on a half of the circle, down on the second half.
        const Vec3 n = (coil.lead < 0.0 ? -1.0 : 1.0) * normalized(cross(u, v));
        EXPECT_NEAR(distance(coil, p), 0.0, 1e-11);
        EXPECT_NEAR(norm(gradient(coil, p) - n), 0.0, 1e-7);
        EXPECT_GT(dot(n, project_onto(coil, p).out), 0.0);
        EXPECT_NEAR(project_onto(coil, p).turn, helix, 1e-9);
    }
}

Spiral random_spiral(Draw& draw) {
    Spiral spiral;
    put_anywhere(spiral, draw);
    spiral.reach = draw.from(2.0, 9.0);
    spiral.lead = draw.from(-0.1, 0.1) * spiral.reach;
    spiral.offset = draw.from(-0.5, 1.0) * spiral.reach;
    return spiral;
}

// The distance is measured from the path, less the offset. The test computes the path itself.
TEST(Spiral, HasItsPlacesNormalsAndDistances) {
    Draw draw(7);
    for (int i = 0; i < 2000; ++i) {
        const Spiral s = random_spiral(draw);
        const double turn = draw.from(-3.0, 3.0), height = draw.from(-5.0, 5.0);
        const double deviation = draw.from(-0.2, 0.2);
        const auto way = [&](double t) {
            return s.centre + (s.reach + s.lead * t) *
                                  (std::cos(t) * s.ahead + std::sin(t) * cross(s.axis, s.ahead));
        };
        constexpr double kStep = 1e-6;
        const Vec3 along = normalized(way(turn + kStep) - way(turn - kStep));
        const Vec3 out = cross(along, s.axis);
        const Vec3 p = way(turn) + (s.offset + deviation) * out + height * s.axis;
        EXPECT_NEAR(distance(s, p), deviation, 1e-8);
        EXPECT_NEAR(norm(gradient(s, p) - out), 0.0, 1e-7);
        const SpiralPlace place = project_onto(s, p);
        EXPECT_NEAR(place.turn, turn, 1e-7);
        EXPECT_NEAR(place.height, height, 1e-9);
        const auto wall = [&](double t) {
            const SpiralPlace at = place_at(s, t);
            return at.path_point + s.offset * at.out;
        };
        const Vec3 step = wall(turn + kStep) - wall(turn - kStep);
        EXPECT_NEAR(dot(step, place.along) / (2.0 * kStep), place.speed, 1e-6);
    }
}

TEST(Coil, IsTheSameFromAnyTurnOn) {
    const Coil coil{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, 6.0, 5.0, -0.5};
    Coil other = coil;
    // A quarter turn and two turns further on.
    other.ahead = {0, 1, 0};
    other.centre.z -= 0.5 * 4.5 * std::numbers::pi;
    EXPECT_TRUE(is_same({coil, true}, {other, true}, 1e-6));
    other.centre.z += 1e-4;
    EXPECT_FALSE(is_same({coil, true}, {other, true}, 1e-5));
    other = coil;
    other.lead = 0.5;
    EXPECT_FALSE(is_same({coil, true}, {other, true}, 1e-5));
}

}  // namespace
}  // namespace ncsim::brep
