// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline patches of domes, coils and spirals.
#include "ncsim/brep/patch.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/angular_extent.h"
#include "topology/envelope_patch.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ncsim::brep {

namespace {

// Control points of a B-spline of degree 5 with triple knots at distance 1.
struct Quintic {
    std::vector<Vec3> points;
    std::vector<double> knots;
};

// Returns the arc from x to y about `centre`, both with the length of the radius and perpendicular;
// a helix if `rise` per radian is not zero. The parameter is the angle: position and two
// derivatives are exact at knots, and between knots 10 degrees apart the error is 6e-10 of the
// radius. CAD readers map circles on this surface to evenly spaced parameters.
Quintic quintic_of_arc(Vec3 centre, Vec3 x, Vec3 y, double begin, double end, double piece,
                       Vec3 rise = {}) {
    const int pieces = std::max(1, static_cast<int>((end - begin) / piece) + 1);
    const double width = (end - begin) / pieces, radians = width * kRadiansPerDegree;
    struct Knot {
        Vec3 at, first, second;  // derivatives by the parameter
    };
    const auto knot = [&](int i) {
        const double degrees = begin + i * width;
        const auto t = sin_cos(degrees);
        const Vec3 out = t.cos * x + t.sin * y;
        return Knot{centre + out + (degrees * kRadiansPerDegree) * rise,
                    radians * (t.cos * y - t.sin * x + rise), (-radians * radians) * out};
    };
    Quintic spline;
    Knot from = knot(0);
    spline.points = {from.at, from.at + 0.2 * from.first};
    for (int i = 0; i < pieces; ++i) {
        const Knot to = knot(i + 1);
        spline.knots.push_back(i);
        spline.points.push_back(from.at + 0.4 * from.first + 0.05 * from.second);
        const Vec3 before = to.at - 0.4 * to.first + 0.05 * to.second,
                   near = to.at - 0.2 * to.first;
        spline.points.push_back(before);
        if (i + 1 < pieces) spline.points.push_back(2.0 * near - before);
        if (i + 1 == pieces) spline.points.insert(spline.points.end(), {near, to.at});
        from = to;
    }
    spline.knots.push_back(pieces);
    return spline;
}

// Extent of a face around a circle and along the circle's path; degrees.
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
// Largest piece of an arc, degrees.
constexpr double kPiece = 10.0;

// Returns the extent of a patch. The patch ends with the face where an edge runs along that end,
// and extends beyond the face elsewhere. OpenCASCADE knows the parameters of edges on the end of a
// patch without a search; near an end of the face at which a wall is tangent, a search is
// inaccurate. `place_of` returns both angles of a point, degrees; the radii are those of both
// circles, mm.
template <typename PlaceOf>
Reach reach_of_patch(const Part& part, const Face& face, const Reach& reach,
                     const PlaceOf& place_of, double radius_around, double radius_along) {
    std::array<bool, 4> ends{};  // first, last, low, high
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        const Track track = track_of(part, edge);
        std::array<double, 2> farthest{};
        std::array<std::array<double, 2>, 5> places{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = place_of(track.at(0.25 * static_cast<double>(i)));
            for (std::size_t k = 0; k < 2; ++k)
                farthest[k] = std::max(farthest[k], std::abs(places[i][k] - places[0][k]));
        }
        const auto is_at = [&](std::size_t k, double end, double radius) {
            const double most = kTangencyGapMm / (radius * kRadiansPerDegree);
            return farthest[k] <= most && std::abs(places[0][k] - end) <= most;
        };
        ends[0] = ends[0] || is_at(0, reach.first, radius_around);
        ends[1] = ends[1] || is_at(0, reach.last, radius_around);
        ends[2] = ends[2] || is_at(1, reach.low, radius_along);
        ends[3] = ends[3] || is_at(1, reach.high, radius_along);
    }
    return {ends[0] ? reach.first : reach.first - kBeyond,
            ends[1] ? reach.last : reach.last + kBeyond, ends[2] ? reach.low : reach.low - kBeyond,
            ends[3] ? reach.high : reach.high + kBeyond};
}

Patch patch_of_dome(const Part& part, const Face& face, const Dome& dome) {
    const Vec3 x = face.frame.x, y = cross(dome.axis, x);
    Reach reach;
    const auto place_of = [&](Vec3 p) {
        const DomePlace place = project_onto(dome, p);
        const double angle = angle_of(dot(place.out, x), dot(place.out, y));
        return std::array{angle < 0.0 ? angle + 360.0 : angle, place.degrees()};
    };
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const auto [around, along] = place_of(p);
            reach.take(around, along);
        }
    }
    const Reach patch_reach = reach_of_patch(part, face, reach, place_of, dome.radius, dome.reach);
    const Quintic circle =
        quintic_of_arc({}, dome.radius * x, dome.radius * y, std::max(0.0, patch_reach.first),
                       std::min(360.0, patch_reach.last), kPiece);
    const Quintic arc = quintic_of_arc(dome.centre, dome.reach * dome.ahead, dome.reach * dome.axis,
                                       patch_reach.low, patch_reach.high, kPiece);
    Patch patch{{}, circle.knots, arc.knots, 5};
    for (const Vec3& p : circle.points) {
        auto& row = patch.net.emplace_back();
        for (const Vec3& q : arc.points)
            row.push_back(p + q);
    }
    return patch;
}

// True if a level circle is at `degrees`, so that the patch may end there. CAD readers know the
// parameters of edges on the end of a patch without a search.
bool ends_level(const Part& part, const Face& face, const Coil& coil, double degrees) {
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        const auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle || std::abs(dot(circle->axis, coil.axis)) < 1.0 - kRounding) continue;
        const double turn = place_at_height(coil, part.vertices[edge.from]).turn;
        if (std::abs(turn / kRadiansPerDegree - degrees) < kRounding) return true;
    }
    return false;
}

// Returns the patch of a coil. The control values of cosine and sine are those of an arc of radius
// 1, so each control point of the circle turns about the axis as the path does.
Patch patch_of_coil(const Part& part, const Face& face, const Coil& coil) {
    double ahead = 0.0;
    Reach reach;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const CoilPlace place = project_onto(coil, p);
            ahead += dot(place.out, place.motion);
            reach.take(0.0, place.turn / kRadiansPerDegree);
        }
    }
    const double sign = ahead < 0.0 ? -1.0 : 1.0;
    const Vec3 side = cross(coil.axis, coil.ahead);
    double low = reach.low, high = reach.high;
    if (!ends_level(part, face, coil, low)) low -= kBeyond;
    if (!ends_level(part, face, coil, high)) high += kBeyond;
    // The circle is ahead at t = 0 in the direction of `side`.
    const Quintic circle =
        quintic_of_arc({}, (sign * coil.radius) * side, (-sign * coil.radius) * coil.ahead,
                       -kQuarterTurnDegrees, kQuarterTurnDegrees, kPiece);
    const Quintic turn = quintic_of_arc({}, {1, 0, 0}, {0, 1, 0}, low, high, kPiece);
    const Quintic path = quintic_of_arc(coil.centre, coil.reach * coil.ahead, coil.reach * side,
                                        low, high, kPiece, coil.lead * coil.axis);
    Patch patch{{}, circle.knots, turn.knots, 5};
    for (const Vec3& p : circle.points) {
        auto& row = patch.net.emplace_back();
        const Vec3 across = cross(coil.axis, p);
        for (std::size_t i = 0; i < path.points.size(); ++i)
            row.push_back(path.points[i] + turn.points[i].x * p + turn.points[i].y * across);
    }
    return patch;
}

// Returns the patch of a spiral. The pieces are those of an arc, because the wall is nearly an arc,
// with the speed of the wall. Along the axis, the patch is a line, as a cubic.
Patch patch_of_spiral(const Part& part, const Face& face, const Spiral& spiral) {
    Reach reach;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const SpiralPlace place = project_onto(spiral, p);
            reach.take(place.height, place.turn / kRadiansPerDegree);
        }
    }
    const double low = reach.low - kBeyond, high = reach.high + kBeyond;
    // Pieces of 3 degrees are off by 2e-9 of the radius.
    const int pieces = std::max(1, static_cast<int>((high - low) / 3.0) + 1);
    const double width = (high - low) / pieces;
    const double handle = 4.0 / 3.0 * tangent(0.25 * width);
    Spline wall;
    for (int i = 0; i <= pieces; ++i) {
        const SpiralPlace place = place_at(spiral, (low + i * width) * kRadiansPerDegree);
        const Vec3 at = place.path_point + spiral.offset * place.out;
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
