// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points on spirals.
#include "ncsim/base/angles.h"
#include "ncsim/brep/surface_forms.h"

#include "geometry/tolerances.h"

#include <cmath>

namespace ncsim::brep {

namespace {

// Returns the speed of a point at `offset` from the path, mm per radian. The tangent of the path
// turns by the angle, and by the change of the tangent's angle to the circle.
double pace_at(const Spiral& spiral, double turn, double offset) {
    const double reach = spiral.reach + spiral.lead * turn;
    const double square = reach * reach + spiral.lead * spiral.lead;
    return std::sqrt(square) + offset * (1.0 + spiral.lead * spiral.lead / square);
}

}  // namespace

SpiralPlace place_at(const Spiral& spiral, double turn) {
    const auto t = sin_cos(turn / kRadiansPerDegree);
    const Vec3 side = cross(spiral.axis, spiral.ahead);
    const Vec3 up = t.cos * spiral.ahead + t.sin * side,
               tangent = t.cos * side - t.sin * spiral.ahead;
    const double reach = spiral.reach + spiral.lead * turn;
    const double pace = std::sqrt(reach * reach + spiral.lead * spiral.lead);
    SpiralPlace place;
    place.turn = turn;
    place.path_point = spiral.centre + reach * up;
    place.along = (1.0 / pace) * (spiral.lead * up + reach * tangent);
    place.out = (1.0 / pace) * (reach * up - spiral.lead * tangent);
    place.speed = pace_at(spiral, turn, spiral.offset);
    return place;
}

SpiralPlace project_onto(const Spiral& spiral, Vec3 p) {
    const Vec3 v = p - spiral.centre;
    const double height = dot(v, spiral.axis);
    const Vec3 level = spiral.centre + (v - height * spiral.axis);
    const double x = dot(v, spiral.ahead), y = dot(v, cross(spiral.axis, spiral.ahead));
    SpiralPlace place = place_at(spiral, angle_of(x, y) * kRadiansPerDegree);
    // Newton's method for the angle at which `p` lies across the path. The derivative is the speed
    // of the offset path through `p`.
    for (int step = 0; step < 40; ++step) {
        const Vec3 deviation = level - place.path_point;
        const double pace = pace_at(spiral, place.turn, dot(deviation, place.out));
        if (!(pace > kRounding)) break;
        double turn = dot(deviation, place.along) / pace;
        if (std::abs(turn) > 0.3) turn = turn < 0.0 ? -0.3 : 0.3;
        place = place_at(spiral, place.turn + turn);
        if (std::abs(turn) < 0.01 * kUnitRounding) break;
    }
    place.height = height;
    return place;
}

}  // namespace ncsim::brep
