// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/reader_compatibility.h"

#include "geometry/tolerances.h"
#include "topology/edge_splitter.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

namespace ncsim::brep {

namespace {

// True if the ends of an edge are too far apart about the circle, seen along the line of the
// extrusion. The direction of an edge of half a turn is ambiguous. On shallow extrusions, which are
// flat across the line, too, CAD readers locate points of edges only roughly; if an edge is long,
// CAD readers draw nothing.
bool is_too_wide(const Extrusion& extrusion, const Part& part, const Edge& edge) {
    const auto out = [&](std::uint32_t v) {
        const Vec3 p = part.vertices[v];
        return normalized(p - place_along(extrusion, p) * extrusion.along - extrusion.centre);
    };
    const double widest = std::abs(dot(extrusion.along, extrusion.axis)) < 0.1 ? 0.8 : -0.9;
    return edge.from != edge.to && dot(out(edge.from), out(edge.to)) < widest;
}

// True if the direction of motion of the sweep at the middle or the end of an edge is more than 60
// degrees from the direction at the start. CAD readers integrate roughly along long edges on spline
// surfaces.
bool is_too_wide(const Envelope& envelope, const Part& part, const Edge& edge) {
    const auto ahead = [&](Vec3 p) {
        const ClosestPoint closest = project_onto(envelope, p);
        return normalized(velocity_at(closest.tool, height_of_centre(*envelope.sweep, closest)));
    };
    const Track track = track_of(part, edge);
    const Vec3 first = ahead(part.vertices[edge.from]);
    return dot(first, ahead(track.at(0.5))) < 0.5 ||
           dot(first, ahead(part.vertices[edge.to])) < 0.5;
}

// True if an edge comes nearer to the axis of the sphere than half the radius, and goes more than a
// quarter of a turn around the axis. CAD readers place these edges some hundredths of a millimetre
// away from the true position, except circles about the axis.
bool passes_by_pole(const Sphere& sphere, const Frame& frame, const Part& part, const Edge& edge) {
    const auto* circle = std::get_if<Circle>(&edge.curve);
    if (circle && norm(cross(circle->axis, frame.axis)) < kRounding) return false;
    const Track track = track_of(part, edge);
    double nearest = 1.0, least = 1.0;  // of the radius; cosine of the angle around
    std::optional<Vec3> first;
    for (const double t : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0}) {
        const Vec3 v = track.at(t) - sphere.centre;
        const Vec3 out = v - dot(v, frame.axis) * frame.axis;
        const double radius = norm(out);
        nearest = std::min(nearest, radius / sphere.radius);
        // At a pole, the angle around the axis is undefined.
        if (radius < 1e-6 * sphere.radius) continue;
        const Vec3 direction = (1.0 / radius) * out;
        if (!first) first = direction;
        least = std::min(least, dot(*first, direction));
    }
    return nearest < 0.5 && least < 0.0;
}

// Halves each edge that is too wide. True if an edge was halved.
bool split_once(Part& part) {
    bool any = false;
    EdgeSplitter halving(part);
    for (const Face& face : part.faces) {
        const auto* extrusion = std::get_if<Extrusion>(&face.surface.form);
        const auto* sphere = std::get_if<Sphere>(&face.surface.form);
        const auto* envelope = std::get_if<Envelope>(&face.surface.form);
        if (!extrusion && !sphere && !envelope) continue;
        const auto is_wide = [&](const Edge& edge) {
            if (envelope) return is_too_wide(*envelope, part, edge);
            if (extrusion)
                return !std::holds_alternative<Circle>(edge.curve) &&
                       is_too_wide(*extrusion, part, edge);
            return passes_by_pole(*sphere, face.frame, part, edge);
        };
        for (const EdgeUse& use : uses_of(face))
            any = (is_wide(part.edges[use.edge]) && halving.halve(use.edge)) || any;
    }
    halving.finish();
    return any;
}

}  // namespace

void split_wide_edges(Part& part) {
    while (split_once(part)) {
    }
}

void split_edges_of_lenses(Part& part) {
    EdgeSplitter halving(part);
    for (const Face& face : part.faces) {
        if (face.loops.size() != 1 || face.loops.front().size() != 2) continue;
        const std::uint32_t one = face.loops[0][0].edge, other = face.loops[0][1].edge;
        if (one == other || part.edges[one].from == part.edges[one].to) continue;
        const auto middle = [&](std::uint32_t e) {
            const Edge& edge = part.edges[e];
            return track_of(part, edge).at(0.5);
        };
        if (norm(middle(one) - middle(other)) > 100.0 * kLeastSizeMm) continue;
        halving.divide(one, 0.5);
        halving.divide(other, 0.5);
    }
    halving.finish();
}

}  // namespace ncsim::brep
