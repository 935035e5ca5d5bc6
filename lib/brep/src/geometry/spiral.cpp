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
    const double x = dot(v, spiral.ahead), y = dot(v, cross(spiral.axis, spiral.ahead));
    // Newton's method for the angle at which `p` lies across the path, in the plane of the path.
    // The derivative is the speed of the offset path through `p`.
    double turn = angle_of(x, y) * kRadiansPerDegree;
    for (int step = 0; step < 40; ++step) {
        const auto t = sin_cos(turn / kRadiansPerDegree);
        const double reach = spiral.reach + spiral.lead * turn;
        const double up = t.cos * x + t.sin * y - reach, tangent = t.cos * y - t.sin * x;
        const double pace = std::sqrt(reach * reach + spiral.lead * spiral.lead);
        const double speed = pace_at(spiral, turn, (reach * up - spiral.lead * tangent) / pace);
        if (!(speed > kRounding)) break;
        double change = (spiral.lead * up + reach * tangent) / (pace * speed);
        if (std::abs(change) > 0.3) change = change < 0.0 ? -0.3 : 0.3;
        turn += change;
        if (std::abs(change) < 0.01 * kUnitRounding) break;
    }
    SpiralPlace place = place_at(spiral, turn);
    place.height = height;
    return place;
}

}  // namespace ncsim::brep
