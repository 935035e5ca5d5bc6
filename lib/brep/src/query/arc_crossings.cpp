// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings of circles and lines that share a corner.
#include "query/arc_crossings.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

// Edge of a plane.
struct PlaneEdge {
    const Edge* edge = nullptr;
    const Circle* circle = nullptr;  // null if the edge is straight
    std::uint32_t number = 0;
    Vec3 from, to;
};

// True if `p`, a point of the curve, is between the ends of the edge.
bool is_inside(const PlaneEdge& e, Vec3 p) {
    if (!e.circle) {
        const Vec3 along = e.to - e.from;
        const double at = dot(p - e.from, along);
        return at > 0.0 && at < dot(along, along);
    }
    if (e.edge->from == e.edge->to) return true;
    const Vec3 x = radial_vector(e.circle->centre, e.circle->axis, e.from),
               y = cross(e.circle->axis, x);
    const auto angle = [&](Vec3 q) {
        const double degrees = angle_of(dot(q - e.circle->centre, x), dot(q - e.circle->centre, y));
        return degrees < 0.0 ? degrees + 360.0 : degrees;
    };
    return angle(p) < angle(e.to);
}

// Returns the distance of the edge from the middle of the chord between two points of the edge,
// positive to the side of `side`.
double depth_of(const PlaneEdge& e, Vec3 middle, Vec3 side) {
    if (!e.circle) return 0.0;
    const Vec3 out = radial_vector(e.circle->centre, e.circle->axis, middle);
    const double depth = e.circle->radius - norm(out);
    return dot(out, side) < 0.0 ? -depth : depth;
}

// Returns the points in which the curves of both edges meet, if the curves differ.
std::vector<Vec3> crossings_of(const PlaneEdge& a, const PlaneEdge& b) {
    if (!a.circle) return crossings_of(b, a);
    const Circle& circle = *a.circle;
    if (b.circle) {
        const Vec3 separation = radial_vector(circle.centre, circle.axis, b.circle->centre);
        const double d = norm(separation), r = circle.radius, s = b.circle->radius;
        if (d < kPointError) return {};
        const double ahead = 0.5 * (d + (r - s) * (r + s) / d);
        const double square = (r - ahead) * (r + ahead);
        if (square < 0.0) return {};
        const Vec3 foot = circle.centre + (ahead / d) * separation;
        const Vec3 aside = (std::sqrt(square) / d) * cross(circle.axis, separation);
        return {foot + aside, foot - aside};
    }
    const double length = norm(b.to - b.from);
    if (length == 0.0) return {};
    const Vec3 along = (1.0 / length) * (b.to - b.from);
    const Vec3 out = radial_vector(circle.centre, circle.axis, b.from);
    const Vec3 foot = b.from - dot(out, along) * along;
    const double deviation = norm(radial_vector(circle.centre, circle.axis, foot));
    const double square = (circle.radius - deviation) * (circle.radius + deviation);
    if (square < 0.0) return {};
    return {foot + std::sqrt(square) * along, foot - std::sqrt(square) * along};
}

bool cross_near_corner(const Part& part, const PlaneEdge& a, const PlaneEdge& b) {
    if (!a.circle && !b.circle) return false;
    for (const Vec3 p : crossings_of(a, b)) {
        if (!is_inside(a, p) || !is_inside(b, p)) continue;
        double nearest = -1.0;
        Vec3 corner;
        for (const std::uint32_t v : {a.edge->from, a.edge->to}) {
            if (v != b.edge->from && v != b.edge->to) continue;
            const double deviation = norm(p - part.vertices[v]);
            if (nearest >= 0.0 && deviation >= nearest) continue;
            nearest = deviation;
            corner = part.vertices[v];
        }
        if (nearest <= kPointError) continue;
        const Vec3 axis = a.circle ? a.circle->axis : b.circle->axis;
        const Vec3 middle = 0.5 * (corner + p), side = cross(axis, p - corner);
        // OpenCASCADE searches crossings to 1e-10 mm; nearer curves are tangent.
        if (std::abs(depth_of(a, middle, side) - depth_of(b, middle, side)) > 0.1 * kRounding)
            return true;
    }
    return false;
}

}  // namespace

std::optional<std::array<std::uint32_t, 2>> arcs_crossing_near_corner(const Part& part,
                                                                      const Face& face) {
    std::map<std::uint32_t, std::vector<PlaneEdge>> at;  // by vertex
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        const auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle && !std::holds_alternative<Line>(edge.curve)) continue;
        const PlaneEdge seen{&edge, circle, use.edge, part.vertices[edge.from],
                             part.vertices[edge.to]};
        at[edge.from].push_back(seen);
        if (edge.to != edge.from) at[edge.to].push_back(seen);
    }
    for (const auto& [v, edges] : at) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                if (edges[i].number != edges[j].number &&
                    cross_near_corner(part, edges[i], edges[j]))
                    return {{edges[i].number, edges[j].number}};
            }
        }
    }
    return std::nullopt;
}

}  // namespace ncsim::brep
