// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/patch.h"

#include "ncsim/trig/angles.h"

#include "topology/around.h"
#include "topology/envelope_patch.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;

// The arc from x to y about `centre`, both of its radius and at right angles; in cubics that have
// the ends and directions of the arc, and meet it in the middle (Goldapp, Approximation of Circular
// Arcs by Cubic Polynomials, 1991).
// `rise` is what it climbs for each radian: a helix.
Spline spline_of_arc(Vec3 centre, Vec3 x, Vec3 y, double begin, double end, double piece,
                     Vec3 rise = {}) {
    const int pieces = std::max(1, static_cast<int>((end - begin) / piece) + 1);
    const double width = (end - begin) / pieces;
    const double handle = 4.0 / 3.0 * trig::tangent(0.25 * width);
    Spline spline;
    for (int i = 0; i <= pieces; ++i) {
        const double degrees = begin + i * width;
        const auto t = trig::sin_cos(degrees);
        const Vec3 at = centre + t.cos * x + t.sin * y + (degrees * trig::kRadiansPerDegree) * rise;
        const Vec3 on = handle * (t.cos * y - t.sin * x + rise);
        spline.points.push_back(i == 0 ? at : at - on);
        spline.points.push_back(i == pieces ? at : at + on);
        spline.knots.push_back(i);
    }
    return spline;
}

// How far a face goes around a circle, and along its way; degrees.
struct Reach {
    double first = 1e9, last = -1e9, low = 1e9, high = -1e9;
    void take(double around, double along) {
        first = std::min(first, around);
        last = std::max(last, around);
        low = std::min(low, along);
        high = std::max(high, along);
    }
};

constexpr double kBeyond = 4.0;  // degrees
// So wide are pieces, degrees: within 2e-10 of the radius, and within 1.2e-8.
constexpr double kPieceOfDome = 7.5, kPieceOfCoil = 15.0;
// Of spirals, within 2e-9 of the radius.
constexpr double kPieceOfSpiral = 3.0;

Patch patch_of_dome(const Part& part, const Face& face, const Dome& dome) {
    const Vec3 x = face.frame.x, y = cross(dome.axis, x);
    Reach reach;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const DomePlace place = place_on(dome, p);
            const double angle = trig::angle_of(dot(place.out, x), dot(place.out, y));
            reach.take(angle < 0.0 ? angle + 360.0 : angle, place.degrees());
        }
    }
    const Spline circle =
        spline_of_arc({}, dome.radius * x, dome.radius * y, std::max(0.0, reach.first - kBeyond),
                      std::min(360.0, reach.last + kBeyond), kPieceOfDome);
    const Spline arc = spline_of_arc(dome.centre, dome.reach * dome.ahead, dome.reach * dome.axis,
                                     reach.low - kBeyond, reach.high + kBeyond, kPieceOfDome);
    Patch patch{{}, circle.knots, arc.knots};
    for (const Vec3& p : circle.points) {
        auto& row = patch.net.emplace_back();
        for (const Vec3& q : arc.points)
            row.push_back(p + q);
    }
    return patch;
}

// Is it where a level circle is, so that the patch may end there? Readers know what lies on the end
// of a patch without looking for it.
bool ends_level(const Part& part, const Face& face, const Coil& coil, double degrees) {
    constexpr double kOn = 1e-9;
    for (const Loop& loop : face.loops) {
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            const auto* circle = std::get_if<Circle>(&edge.curve);
            if (!circle || std::abs(dot(circle->axis, coil.axis)) < 1.0 - kOn) continue;
            const double turn = place_at_height(coil, part.vertices[edge.from]).turn;
            if (std::abs(turn / trig::kRadiansPerDegree - degrees) < kOn) return true;
        }
    }
    return false;
}

// Control numbers of a spline of sine and cosine are those of an arc of radius 1, so that each
// control point of the circle turns about the axis as the way does.
Patch patch_of_coil(const Part& part, const Face& face, const Coil& coil) {
    double ahead = 0.0;
    Reach reach;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const CoilPlace place = place_on(coil, p);
            ahead += dot(place.out, place.way);
            reach.take(0.0, place.turn / trig::kRadiansPerDegree);
        }
    }
    const double sign = ahead < 0.0 ? -1.0 : 1.0;
    const Vec3 side = cross(coil.axis, coil.ahead);
    constexpr double kHalf = 90.0;
    double low = reach.low, high = reach.high;
    if (!ends_level(part, face, coil, low)) low -= kBeyond;
    if (!ends_level(part, face, coil, high)) high += kBeyond;
    // Where the circle is ahead for t = 0, and on from there.
    const Spline circle =
        spline_of_arc({}, (sign * coil.radius) * side, (-sign * coil.radius) * coil.ahead, -kHalf,
                      kHalf, kPieceOfCoil);
    const Spline turn = spline_of_arc({}, {1, 0, 0}, {0, 1, 0}, low, high, kPieceOfCoil);
    const Spline way = spline_of_arc(coil.centre, coil.reach * coil.ahead, coil.reach * side, low,
                                     high, kPieceOfCoil, coil.lead * coil.axis);
    Patch patch{{}, circle.knots, turn.knots};
    for (const Vec3& p : circle.points) {
        auto& row = patch.net.emplace_back();
        const Vec3 across = cross(coil.axis, p);
        for (std::size_t i = 0; i < way.points.size(); ++i)
            row.push_back(way.points[i] + turn.points[i].x * p + turn.points[i].y * across);
    }
    return patch;
}

// In pieces as of an arc, since it is nearly one, as fast as the wall goes there. A line upwards,
// as a cubic.
Patch patch_of_spiral(const Part& part, const Face& face, const Spiral& spiral) {
    Reach reach;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const SpiralPlace place = place_on(spiral, p);
            reach.take(place.height, place.turn / trig::kRadiansPerDegree);
        }
    }
    const double low = reach.low - kBeyond, high = reach.high + kBeyond;
    const int pieces = std::max(1, static_cast<int>((high - low) / kPieceOfSpiral) + 1);
    const double width = (high - low) / pieces;
    const double handle = 4.0 / 3.0 * trig::tangent(0.25 * width);
    Spline wall;
    for (int i = 0; i <= pieces; ++i) {
        const SpiralPlace place = place_at(spiral, (low + i * width) * trig::kRadiansPerDegree);
        const Vec3 at = place.way + spiral.offset * place.out;
        const Vec3 on = (handle * place.speed) * place.along;
        wall.points.push_back(i == 0 ? at : at - on);
        wall.points.push_back(i == pieces ? at : at + on);
        wall.knots.push_back(i);
    }
    const double beyond = 0.05 * (reach.last - reach.first);
    const double from = reach.first - beyond, to = reach.last + beyond;
    Patch patch{{}, wall.knots, {0.0, 1.0}};
    for (const Vec3& p : wall.points) {
        auto& row = patch.net.emplace_back();
        for (int i = 0; i <= 3; ++i)
            row.push_back(p + (from + i * (to - from) / 3.0) * spiral.axis);
    }
    return patch;
}

}  // namespace

Patch patch_of(const Part& part, const Face& face) {
    if (const auto* coil = std::get_if<Coil>(&face.surface.form))
        return patch_of_coil(part, face, *coil);
    if (const auto* spiral = std::get_if<Spiral>(&face.surface.form))
        return patch_of_spiral(part, face, *spiral);
    if (const auto* envelope = std::get_if<Envelope>(&face.surface.form))
        return patch_of_envelope(part, face, *envelope);
    return patch_of_dome(part, face, std::get<Dome>(face.surface.form));
}

}  // namespace ncsim::brep
