// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points on coils.
#include "ncsim/base/angles.h"
#include "ncsim/brep/surface_forms.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

namespace {

// Moves the circle of `place` to the angle `turn`.
void turn_to(const Coil& coil, double turn, CoilPlace& place) {
    const auto t = sin_cos(turn / kRadiansPerDegree);
    const Vec3 side = cross(coil.axis, coil.ahead);
    place.turn = turn;
    place.centre = coil.centre + coil.reach * (t.cos * coil.ahead + t.sin * side) +
                   (coil.lead * turn) * coil.axis;
    place.motion = t.cos * side - t.sin * coil.ahead;
}

Vec3 level(const Coil& coil, Vec3 v) {
    return v - dot(v, coil.axis) * coil.axis;
}

}  // namespace

CoilPlace place_at_height(const Coil& coil, Vec3 p) {
    CoilPlace place;
    turn_to(coil, dot(p - coil.centre, coil.axis) / coil.lead, place);
    place.out = normalized(level(coil, p - place.centre));
    if (place.out == Vec3{}) place.out = place.motion;
    return place;
}

CoilPlace project_onto(const Coil& coil, Vec3 p) {
    CoilPlace place = place_at_height(coil, p);
    // Newton's method for both angles at once minimises the distance. Where the second derivatives
    // are not positive definite, the step is the one for `p` on the surface.
    for (int step = 0; step < 40; ++step) {
        const Vec3 deviation = p - place.centre - coil.radius * place.out;
        const Vec3 unit = cross(coil.axis, place.out), tangent = coil.radius * unit;
        const Vec3 along = coil.reach * place.motion + coil.lead * coil.axis;
        const double ab = dot(tangent, along);
        double aa = dot(tangent, tangent), bb = dot(along, along);
        const double bent_a = aa + coil.radius * dot(deviation, place.out);
        const double bent_b = bb + coil.reach * dot(deviation, cross(place.motion, coil.axis));
        const bool is_least = bent_a > 0.0 && bent_a * bent_b - ab * ab > kRounding * aa * bb;
        if (is_least) {
            aa = bent_a;
            bb = bent_b;
        }
        const double det = aa * bb - ab * ab;
        const double a = dot(tangent, deviation), b = dot(along, deviation);
        double first = a / aa, second = 0.0;
        if (is_least || det > kRounding * aa * bb) {
            first = (a * bb - b * ab) / det;
            second = (b * aa - a * ab) / det;
        }
        // Both steps are scaled alike: near a wall both directions are nearly parallel, and a long
        // step in one direction is undone by a step in the other.
        const double longest = std::max(std::abs(first), std::abs(second));
        const double scale = longest > 0.3 ? 0.3 / longest : 1.0;
        place.out = normalized(place.out + (scale * first) * unit);
        if (second != 0.0) turn_to(coil, place.turn + scale * second, place);
        // After a step of Newton's method, the error is of the order of the step's square.
        if (std::abs(first) + std::abs(second) <
            (is_least ? 10.0 * kRounding : 0.1 * kUnitRounding))
            break;
    }
    return place;
}

}  // namespace ncsim::brep
