// SPDX-License-Identifier: GPL-3.0-or-later
#include "readable.h"

#include "none.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

using cda::dot;

// Do its ends lie too far apart, seen along the line that the circle moves along? Where it goes
// half around, nobody knows which way; and along shallow ramps, which are as flat across, readers
// find places of edges roughly: those of long ones so much so that they draw nothing.
bool is_too_wide(const Extrusion& extrusion, const Part& part, const Edge& edge) {
    const auto out = [&](std::uint32_t v) {
        const Vec3 p = part.vertices[v];
        return cda::normalized(p - place_along(extrusion, p) * extrusion.along - extrusion.centre);
    };
    constexpr double kOpposite = -0.9, kShallow = 0.1, kBeside = 0.8;
    const double widest =
        std::abs(dot(extrusion.along, extrusion.axis)) < kShallow ? kBeside : kOpposite;
    return edge.from != edge.to && dot(out(edge.from), out(edge.to)) < widest;
}

// Does the way turn by more than a third of a right angle between its ends, or come back? Readers
// integrate along long edges on splines roughly.
bool is_too_wide(const Envelope& envelope, const Part& part, const Edge& edge) {
    const auto ahead = [&](Vec3 p) {
        return around(*envelope.sweep, place_on(envelope, p).passage).ahead;
    };
    constexpr double kWidest = 0.5;
    const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
    const Vec3 first = ahead(part.vertices[edge.from]);
    return dot(first, ahead(track.at(0.5))) < kWidest ||
           dot(first, ahead(part.vertices[edge.to])) < kWidest;
}

// Does it pass near a pole of the sphere, more than a quarter around it? Readers lay such edges
// down some hundredths of a millimetre from where they are, but for circles about the axis itself.
bool passes_by_pole(const Sphere& sphere, const Frame& frame, const Part& part, const Edge& edge) {
    constexpr double kNear = 0.5, kQuarter = 0.0, kOne = 1e-9;
    const auto* circle = std::get_if<Circle>(&edge.curve);
    if (circle && cda::norm(cda::cross(circle->axis, frame.axis)) < kOne) return false;
    const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
    double nearest = 1.0, least = 1.0;  // of the radius; cosine of the angle around
    std::optional<Vec3> first;
    for (const double t : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0}) {
        const Vec3 v = track.at(t) - sphere.centre;
        const Vec3 out = v - dot(v, frame.axis) * frame.axis;
        const double away = cda::norm(out);
        nearest = std::min(nearest, away / sphere.radius);
        // In a pole there is no direction.
        if (away < 1e-6 * sphere.radius) continue;
        const Vec3 direction = (1.0 / away) * out;
        if (!first) first = direction;
        least = std::min(least, dot(*first, direction));
    }
    return nearest < kNear && least < kQuarter;
}

// At the knot in the middle, where there is one.
std::optional<std::array<Spline, 2>> halves_of(const Spline& spline) {
    const std::size_t knots = spline.knots.size();
    if (knots < 3) return std::nullopt;
    const std::size_t middle = knots / 2;
    const auto width = [&](std::size_t i) { return spline.knots[i + 1] - spline.knots[i]; };
    // Of both control points beside it, as far from each as the pieces are wide.
    const double before = width(middle - 1), after = width(middle);
    const Vec3 at = (1.0 / (before + after)) *
                    (after * spline.points[2 * middle] + before * spline.points[2 * middle + 1]);
    const auto split = [&](auto first, auto last) { return std::vector(first, last); };
    const auto points = [&](std::size_t i) {
        return spline.points.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const auto knot = [&](std::size_t i) {
        return spline.knots.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::array<Spline, 2> halves{
        Spline{split(points(0), points(2 * middle + 1)), split(knot(0), knot(middle + 1))},
        Spline{split(points(2 * middle + 1), spline.points.end()),
               split(knot(middle), spline.knots.end())}};
    halves[0].points.push_back(at);
    halves[1].points.insert(halves[1].points.begin(), at);
    for (double& k : halves[1].knots)
        k -= spline.knots[middle];
    return halves;
}

// True: it has halved one.
bool halve_once(Part& part) {
    bool any = false;
    std::vector<std::uint32_t> second(part.edges.size(), kNone);
    for (const Face& face : part.faces) {
        const auto* extrusion = std::get_if<Extrusion>(&face.surface.form);
        const auto* sphere = std::get_if<Sphere>(&face.surface.form);
        const auto* envelope = std::get_if<Envelope>(&face.surface.form);
        if (!extrusion && !sphere && !envelope) continue;
        const auto is_wide = [&](const Edge& edge) {
            if (envelope) return is_too_wide(*envelope, part, edge);
            return extrusion ? is_too_wide(*extrusion, part, edge)
                             : passes_by_pole(*sphere, face.frame, part, edge);
        };
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const Edge edge = part.edges[use.edge];
                if (use.edge >= second.size() || second[use.edge] != kNone || !is_wide(edge))
                    continue;
                const auto* spline = std::get_if<Spline>(&edge.curve);
                const auto halves = spline ? halves_of(*spline) : std::nullopt;
                const bool is_round = std::holds_alternative<Ellipse>(edge.curve) ||
                                      (sphere && std::holds_alternative<Circle>(edge.curve));
                if (!halves && !is_round) continue;
                any = true;
                const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
                const auto middle = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(halves ? halves->back().points.front() : track.at(0.5));
                second[use.edge] = static_cast<std::uint32_t>(part.edges.size());
                part.edges[use.edge].to = middle;
                if (halves) part.edges[use.edge].curve = halves->front();
                part.edges.push_back({middle, edge.to, halves ? halves->back() : edge.curve});
            }
        }
    }
    for (Face& face : part.faces) {
        for (Loop& loop : face.loops) {
            Loop halved;
            for (const EdgeUse& use : loop) {
                const std::uint32_t other = use.edge < second.size() ? second[use.edge] : kNone;
                if (other != kNone && !use.is_forward) halved.push_back({other, false});
                halved.push_back(use);
                if (other != kNone && use.is_forward) halved.push_back({other, true});
            }
            loop = std::move(halved);
        }
    }
    return any;
}

}  // namespace

void halve_wide_edges(Part& part) {
    while (halve_once(part)) {
    }
}

}  // namespace ncsim::brep
