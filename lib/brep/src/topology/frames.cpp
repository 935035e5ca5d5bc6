// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of parameter frames by form.
#include "ncsim/brep/frames.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/angular_extent.h"
#include "topology/face_edges.h"
#include "topology/whole_circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::brep {

namespace {

// Returns the x axis for a face with these loops.
Vec3 x_axis(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis) {
    const Vec3 x = any_perpendicular(axis);
    const AngularExtent round = angular_extent(loops, origin, axis, x);
    if (round.is_full_turn || round.gap < 0.01) {
        const Vec3 v = loops.front().front() - origin;
        const Vec3 out = v - dot(v, axis) * axis;
        return norm(out) > 1e-6 ? normalized(out) : x;
    }
    const auto angle = sin_cos(round.gap_begin + 0.5 * round.gap);
    return normalized(angle.cos * x + angle.sin * cross(axis, x));
}

// Returns the frame of a wall or cone between whole circles about the axis, as frame_for() would.
std::optional<Frame> frame_of_turned(const Part& part, const Face& face) {
    const auto* cylinder = std::get_if<Cylinder>(&face.surface.form);
    const auto* cone = std::get_if<Cone>(&face.surface.form);
    if (!cylinder && !cone) return std::nullopt;
    const Vec3 origin = cylinder ? cylinder->origin : cone->apex;
    const Vec3 axis = cylinder ? cylinder->axis : cone->axis;
    std::optional<Vec3> first;
    double height = 0.0;
    for (const Loop& loop : face.loops) {
        const auto circle = whole_circle(part, loop);
        if (!circle || !circle->is_about(origin, axis) || circle->radius < kLeastSizeMm)
            return std::nullopt;
        if (!first) first = circle->start;
        height = std::max(height, dot(circle->start - origin, axis));
    }
    const Vec3 v = *first - origin;
    return Frame{cylinder ? origin : origin + height * axis, axis,
                 normalized(v - dot(v, axis) * axis)};
}

// Returns the common axis of a cap or zone, whose edges are circles about the same axis.
std::optional<Vec3> axis_of_zone(const Part& part, const Face& face) {
    std::optional<Vec3> axis;
    for (const EdgeUse& use : uses_of(face)) {
        const auto* circle = std::get_if<Circle>(&part.edges[use.edge].curve);
        if (!circle || (axis && norm(cross(*axis, circle->axis)) > kRounding)) return std::nullopt;
        if (!axis) axis = circle->axis;
    }
    return axis;
}

// Returns the least sine between points of the loops and an axis, as Round::nearest.
double nearest_to(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis) {
    double least = 1.0;  // squared
    for (const auto& points : loops) {
        for (const Vec3& p : points) {
            const Vec3 v = p - origin;
            const double height = dot(v, axis), square = dot(v, v);
            if (square > 0.0) least = std::min(least, 1.0 - height * height / square);
        }
    }
    return std::sqrt(std::max(0.0, least));
}

// Returns the axis of a sphere: as far from the loops as possible, and not through the face.
Vec3 sphere_axis(const std::vector<std::vector<Vec3>>& loops, Vec3 centre) {
    const Vec3 up{0, 0, 1};
    std::vector<Vec3> axes{up};
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            for (int k = 0; k <= 2; ++k) {
                const Vec3 v{double(i), double(j), double(k)};
                if (dot(v, v) > 0.0) axes.push_back(normalized(v));
            }
        }
    }
    Vec3 best = up;
    double farthest = 0.0;
    for (const Vec3& axis : axes) {
        const double nearest = nearest_to(loops, centre, axis);
        if (nearest <= farthest + 1e-3 ||
            angular_extent(loops, centre, axis, any_perpendicular(axis)).is_full_turn)
            continue;
        farthest = nearest;
        best = axis;
    }
    return best;
}

// Returns an axis about which all edges are parameter lines: circles about the axis, or great
// circles through the poles without a pole between their ends. The face contains no pole.
// OpenCASCADE computes the parameters of all other circles on a sphere roughly, to 2e-5 mm for a
// radius of 3 mm, and then finds the curve off its surface.
std::optional<Vec3> axis_of_parameters(const Part& part, const Face& face, const Sphere& sphere) {
    std::vector<const Edge*> edges;
    std::vector<Vec3> normals;
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        const auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle) return std::nullopt;
        edges.push_back(&edge);
        const bool is_known = std::ranges::any_of(
            normals, [&](Vec3 normal) { return norm(cross(normal, circle->axis)) < kRounding; });
        if (!is_known) normals.push_back(circle->axis);
    }
    std::vector<Vec3> axes = normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t j = i + 1; j < normals.size(); ++j)
            axes.push_back(normalized(cross(normals[i], normals[j])));
    }
    const auto is_line_of = [&](const Edge& edge, Vec3 axis) {
        const auto& circle = std::get<Circle>(edge.curve);
        if (norm(cross(circle.axis, axis)) < kRounding) return true;
        const bool is_great = norm(circle.centre - sphere.centre) < kRounding * sphere.radius &&
                              std::abs(dot(circle.axis, axis)) < kRounding;
        if (!is_great || edge.from == edge.to) return false;
        const Vec3 from = part.vertices[edge.from], to = part.vertices[edge.to];
        const double sweep = Track(edge.curve, from, to).sweep_degrees();
        return std::ranges::all_of(std::array{axis, -axis}, [&](Vec3 pole) {
            const Vec3 x = normalized(from - circle.centre), y = cross(circle.axis, x);
            double at = angle_of(dot(pole, x), dot(pole, y));
            if (at < -kPointError) at += kTurnDegrees;
            return at < kPointError || at > sweep - kPointError;
        });
    };
    const auto loops = points_along(part, face);
    for (const Vec3& axis : axes) {
        if (std::ranges::all_of(edges, [&](const Edge* e) { return is_line_of(*e, axis); }) &&
            !angular_extent(loops, sphere.centre, axis, any_perpendicular(axis)).is_full_turn)
            return axis;
    }
    return std::nullopt;
}

// Returns the frame at the start of the first edge, with x along the edge if it is straight.
Frame frame_of_plane(const Part& part, const Face& face, const Plane& plane) {
    const EdgeUse& use = face.loops.front().front();
    const Edge& edge = part.edges[use.edge];
    const Vec3 start = part.vertices[use.is_forward ? edge.from : edge.to];
    Vec3 along = any_perpendicular(plane.normal);
    if (std::holds_alternative<Line>(edge.curve) && edge.from != edge.to) {
        const Vec3 v = part.vertices[edge.to] - part.vertices[edge.from];
        along = normalized(v - dot(v, plane.normal) * plane.normal);
    }
    return {start, plane.normal, along};
}

}  // namespace

bool has_tip(const Part& part, const Face& face) {
    const auto* cone = std::get_if<Cone>(&face.surface.form);
    const auto* torus = std::get_if<Torus>(&face.surface.form);
    if (!cone && !(torus && is_spindle(*torus))) return false;
    const Vec3 axis = cone ? cone->axis : torus->axis;
    const AngularExtent round = angular_extent(
        points_along(part, face), cone ? cone->apex : torus->centre, axis, any_perpendicular(axis));
    return std::abs(round.sum) > 180.0;
}

Frame frame_for(const Part& part, const Face& face) {
    if (const auto* plane = std::get_if<Plane>(&face.surface.form))
        return frame_of_plane(part, face, *plane);
    if (const auto* f = std::get_if<Coil>(&face.surface.form))
        return {f->centre, f->axis, f->ahead};
    if (const auto* f = std::get_if<Spiral>(&face.surface.form))
        return {f->centre, f->axis, f->ahead};
    if (const auto* f = std::get_if<Envelope>(&face.surface.form)) {
        const ToolFrame start = f->sweep->at(0.0);
        return {start.tip, start.axis, any_perpendicular(start.axis)};
    }
    if (const auto frame = frame_of_turned(part, face)) return *frame;
    const auto loops = points_along(part, face);
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form))
        return {f->origin, f->axis, x_axis(loops, f->origin, f->axis)};
    if (const auto* f = std::get_if<Torus>(&face.surface.form)) {
        if (!is_spindle(*f)) return {f->centre, f->axis, x_axis(loops, f->centre, f->axis)};
        // The tip has no angle.
        std::vector<std::vector<Vec3>> clear = loops;
        for (auto& points : clear) {
            std::erase_if(
                points, [&](Vec3 p) { return norm(cross(p - f->centre, f->axis)) < kPointError; });
        }
        return {f->centre, f->axis, x_axis(clear, f->centre, f->axis)};
    }
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const auto zone = axis_of_zone(part, face);
        const Vec3 axis = zone ? *zone : sphere_axis(loops, f->centre);
        return {f->centre, axis, x_axis(loops, f->centre, axis)};
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        // The origin is not the apex, because CAD systems would need a radius of 0 there.
        double height = 0.0;
        for (const auto& points : loops) {
            for (const Vec3& p : points)
                height = std::max(height, dot(p - f->apex, f->axis));
        }
        return {f->apex + height * f->axis, f->axis, x_axis(loops, f->apex, f->axis)};
    }
    if (const auto* f = std::get_if<Extrusion>(&face.surface.form)) {
        // Projects the loops along the line.
        auto seen = loops;
        for (auto& points : seen) {
            for (Vec3& p : points)
                p = p - place_along(*f, p) * f->along;
        }
        return {f->centre, f->axis, x_axis(seen, f->centre, f->axis)};
    }
    const auto& f = std::get<Dome>(face.surface.form);
    // Moves the loops to the centre of the arc, relative to the circle's centre at each point.
    auto seen = loops;
    for (auto& points : seen) {
        for (Vec3& p : points)
            p = p - f.reach * project_onto(f, p).up;
    }
    return {f.centre, f.axis, x_axis(seen, f.centre, f.axis)};
}

Frame frame_in_file(const Part& part, const Face& face) {
    const auto* sphere = std::get_if<Sphere>(&face.surface.form);
    if (!sphere) return face.frame;
    const auto axis = axis_of_parameters(part, face, *sphere);
    if (!axis) return face.frame;
    return {sphere->centre, *axis, x_axis(points_along(part, face), sphere->centre, *axis)};
}

std::optional<Vec3> half_of_ramp(const Part& part, const Face& face) {
    const auto* ramp = std::get_if<Extrusion>(&face.surface.form);
    if (!ramp || std::abs(dot(ramp->along, ramp->axis)) >= 0.1) return std::nullopt;
    const Vec3 ahead = normalized(ramp->along - dot(ramp->along, ramp->axis) * ramp->axis);
    const auto place = [&](Vec3 p) {
        return dot(p - place_along(*ramp, p) * ramp->along - ramp->centre, ahead) / ramp->radius;
    };
    const bool ends_beside_side = std::ranges::any_of(uses_of(face), [&](const EdgeUse& use) {
        const double at = std::abs(place(part.vertices[begin_of(part, use)]));
        // Corners nearer to the side are corners of walls, displaced by rounding.
        return at > 1e-4 && at < 0.05;
    });
    if (!ends_beside_side) return std::nullopt;
    double rearmost = 1.0, foremost = -1.0;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3 p : points) {
            rearmost = std::min(rearmost, place(p));
            foremost = std::max(foremost, place(p));
        }
    }
    if (rearmost > -1e-3) return ahead;
    if (foremost < 1e-3) return -ahead;
    return std::nullopt;
}

}  // namespace ncsim::brep
