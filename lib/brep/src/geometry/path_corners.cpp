// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners of tool paths: common planes and circles of the surfaces before and after a corner.
#include "geometry/path_corners.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ncsim::brep {

namespace {

// Returns the planes of bend_planes() in path_corners.h, for extrusions.
std::optional<std::array<Plane, 2>> bend_planes(const Extrusion& a, const Extrusion& b) {
    if (std::abs(a.radius - b.radius) > kPointError || !is_parallel(a.axis, b.axis))
        return std::nullopt;
    // Offset between the circles at the height of the first centre, and the offset's growth per mm
    // of height.
    const auto lean = [&](const Extrusion& e) { return (1.0 / dot(e.along, a.axis)) * e.along; };
    const Vec3 first = lean(a), second = lean(b), drift = second - first;
    const Vec3 separation = b.centre + dot(a.centre - b.centre, a.axis) * second - a.centre;
    const double length = norm(drift);
    if (length < 3.0 * kParallelAngle || norm(cross(separation, drift)) > kPointError * length)
        return std::nullopt;
    const Vec3 centre = a.centre - (dot(separation, drift) / (length * length)) * first;
    return {{Plane{centre, a.axis},
             Plane{centre, normalized(cross(first + second, cross(a.axis, drift)))}}};
}

// Returns the centre of the circle that `dome` has in common with an equal circle that moves along
// a line. If there are two, returns the centre nearest to the height of `p`.
std::optional<Vec3> common_circle(const Dome& dome, const Form& other, Vec3 p) {
    const auto moved = moved_circle(other, dome.axis);
    if (!moved || std::abs(moved->radius - dome.radius) > kPointError ||
        !is_parallel(moved->axis, dome.axis))
        return std::nullopt;
    const Vec3 side = cross(dome.axis, dome.ahead), v = moved->centre - dome.centre;
    if (std::abs(dot(moved->along, side)) > kParallelAngle || !is_near(dot(v, side), 0.0))
        return std::nullopt;
    // `nearest` is the line's point nearest to the arc's centre; `half` leads from there to the
    // arc.
    const Vec3 nearest = v - dot(v, moved->along) * moved->along;
    const double deviation = norm(nearest);
    if (deviation > dome.reach + kTangencyGapMm) return std::nullopt;
    const double half = std::sqrt(std::max(0.0, dome.reach * dome.reach - deviation * deviation));
    std::optional<Vec3> best;
    for (const double sign : {-1.0, 1.0}) {
        const Vec3 centre = nearest + (sign * half) * moved->along;
        if (dot(centre, dome.ahead) < -kTangencyGapMm) continue;
        const auto far = [&](Vec3 c) { return std::abs(dot(p - dome.centre - c, dome.axis)); };
        if (!best || far(centre) < far(*best)) best = centre;
    }
    if (best) *best = *best + dome.centre;
    return best;
}

// Circle that does not turn, at the height of a point: the centre, and the centre's displacement
// per mm along the axis.
struct MovingCircle {
    Vec3 centre, slope;
    double radius = 0.0;
};

std::optional<MovingCircle> circle_at_height(const Form& form, Vec3 axis, Vec3 p) {
    if (const auto* f = std::get_if<Coil>(&form)) {
        if (!is_parallel(f->axis, axis)) return std::nullopt;
        const CoilPlace place = place_at_height(*f, p);
        return MovingCircle{place.centre, axis + (f->reach / f->lead) * place.motion, f->radius};
    }
    const auto moved = moved_circle(form, axis);
    if (!moved || !is_parallel(moved->axis, axis)) return std::nullopt;
    const Vec3 slope = (1.0 / dot(moved->along, axis)) * moved->along;
    return MovingCircle{moved->centre + dot(p - moved->centre, axis) * slope, slope, moved->radius};
}

// Returns the centre of the circle that `coil` has in common with an equal circle, near the height
// of `p`.
std::optional<Vec3> common_circle(const Coil& coil, const Form& other, Vec3 p) {
    const Vec3 start = p;
    if (const auto* wall = std::get_if<Cylinder>(&other)) {
        // The circle passes the cylinder once per turn.
        if (!is_parallel(wall->axis, coil.axis)) return std::nullopt;
        const CoilPlace near_p = place_at_height(coil, p);
        const Vec3 up = radial_vector(coil.centre, coil.axis, near_p.centre);
        const Vec3 to = radial_vector(coil.centre, coil.axis, wall->origin);
        const double degrees = angle_of(dot(to, up), dot(to, cross(coil.axis, up)));
        p = near_p.centre + (degrees * kRadiansPerDegree * coil.lead) * coil.axis;
    }
    Vec3 at = p;
    for (int step = 0; step < kMostSteps / 2; ++step) {
        const auto one = circle_at_height(coil, coil.axis, at);
        const auto two = circle_at_height(other, coil.axis, at);
        if (!two || std::abs(two->radius - coil.radius) > kPointError) return std::nullopt;
        const Vec3 separation = two->centre - one->centre, drift = two->slope - one->slope;
        const double square = dot(drift, drift);
        if (square < kPointError * kPointError) return std::nullopt;
        const double farthest = 0.3 * std::abs(coil.lead);
        const double up = std::clamp(-dot(separation, drift) / square, -farthest, farthest);
        at = at + up * coil.axis;
        if (std::abs(up) > 0.01 * kUnitRounding && step + 1 < kMostSteps / 2) continue;
        if (norm(separation) > kTangencyGapMm || !belongs_to_circle(coil, one->centre, start))
            return std::nullopt;
        return one->centre;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::array<Plane, 2>> mitre_planes(const Cylinder& a, const Cylinder& b) {
    const Vec3 normal = cross(a.axis, b.axis);
    if (std::abs(a.radius - b.radius) > kPointError || norm(normal) < 3.0 * kParallelAngle)
        return std::nullopt;
    if (std::abs(dot(b.origin - a.origin, normal)) > kPointError * norm(normal))
        return std::nullopt;
    // Point of the first axis in the plane of the second axis and the normal.
    const Vec3 side = cross(normal, b.axis);
    const Vec3 centre = a.origin + (dot(b.origin - a.origin, side) / dot(a.axis, side)) * a.axis;
    return {
        {Plane{centre, normalized(a.axis - b.axis)}, Plane{centre, normalized(a.axis + b.axis)}}};
}

std::optional<Extrusion> moved_circle(const Form& form, Vec3 axis) {
    if (const auto* f = std::get_if<Extrusion>(&form)) return *f;
    const auto* f = std::get_if<Cylinder>(&form);
    if (!f || !is_parallel(f->axis, axis)) return std::nullopt;
    return Extrusion{f->origin, axis, axis, f->radius};
}

std::optional<std::array<Plane, 2>> bend_planes(const Form& a, const Form& b) {
    const auto* one = std::get_if<Extrusion>(&a);
    const auto* other = std::get_if<Extrusion>(&b);
    if (!one && !other) return std::nullopt;
    const Vec3 axis = one ? one->axis : other->axis;
    const auto first = moved_circle(a, axis), second = moved_circle(b, axis);
    return first && second ? bend_planes(*first, *second) : std::nullopt;
}

bool belongs_to_circle(const Coil& coil, Vec3 centre, Vec3 p) {
    return dot(project_onto(coil, p).out, p - centre) > 0.0;
}

bool belongs_to_circle(const Dome& dome, Vec3 centre, Vec3 p) {
    return dot(project_onto(dome, p).out, p - centre) > 0.0;
}

std::optional<Vec3> common_circle(const Form& a, const Form& b, Vec3 p) {
    if (const auto* coil = std::get_if<Coil>(&b)) return common_circle(*coil, a, p);
    if (const auto* coil = std::get_if<Coil>(&a)) return common_circle(*coil, b, p);
    if (const auto* dome = std::get_if<Dome>(&b)) return common_circle(*dome, a, p);
    if (const auto* dome = std::get_if<Dome>(&a)) return common_circle(*dome, b, p);
    return std::nullopt;
}

namespace {

// Path of a ball's centre: a line, or a circle about `axis`.
struct CentrePath {
    Vec3 centre, axis;
    double reach = 0.0;  // 0 for a line along `axis`
    double ball = 0.0;
    Vec3 direction_at(Vec3 p) const {
        return reach > 0.0 ? normalized(cross(axis, p - centre)) : axis;
    }
};

std::optional<CentrePath> centre_path(const Form& form) {
    if (const auto* pipe = std::get_if<Cylinder>(&form))
        return CentrePath{pipe->origin, pipe->axis, 0.0, pipe->radius};
    if (const auto* ring = std::get_if<Torus>(&form))
        return CentrePath{ring->centre, ring->axis, ring->major, ring->minor};
    return std::nullopt;
}

// Returns where the line and the circle meet.
std::vector<Vec3> common_points(const CentrePath& circle, const CentrePath& line) {
    const double height = dot(line.centre - circle.centre, circle.axis);
    const double lean = dot(line.axis, circle.axis);
    if (!is_perpendicular(line.axis, circle.axis)) {
        const Vec3 at = line.centre - (height / lean) * line.axis;
        if (is_near(norm(at - circle.centre), circle.reach)) return {at};
        return {};
    }
    const Vec3 foot = line.centre + dot(circle.centre - line.centre, line.axis) * line.axis;
    const double off = norm(foot - circle.centre);
    if (!is_near(height, 0.0)) return {};
    if (is_near(off, circle.reach)) return {foot};
    if (off >= circle.reach) return {};
    const double half = std::sqrt(circle.reach * circle.reach - off * off);
    return {foot + half * line.axis, foot - half * line.axis};
}

// Returns where two circles in one plane meet.
std::vector<Vec3> common_points_of_circles(const CentrePath& a, const CentrePath& b) {
    const Vec3 between = b.centre - a.centre;
    const double d = norm(between);
    if (!is_parallel(a.axis, b.axis) || !is_near(dot(between, a.axis), 0.0) ||
        d < kLeastAxisDistance)
        return {};
    const double along = 0.5 * (d + (a.reach - b.reach) * (a.reach + b.reach) / d);
    const Vec3 ahead = (1.0 / d) * between, side = cross(a.axis, ahead);
    if (is_near(std::abs(along), a.reach)) return {a.centre + along * ahead};
    if (std::abs(along) >= a.reach) return {};
    const double half = std::sqrt(a.reach * a.reach - along * along);
    return {a.centre + along * ahead + half * side, a.centre + along * ahead - half * side};
}

}  // namespace

std::optional<Vec3> crossing_of_grooves(const Form& a, const Form& b, Vec3 p) {
    const auto one = centre_path(a), other = centre_path(b);
    if (!one || !other || !is_near(one->ball, other->ball) ||
        (one->reach == 0.0 && other->reach == 0.0))
        return std::nullopt;
    const std::vector<Vec3> common = one->reach == 0.0     ? common_points(*other, *one)
                                     : other->reach == 0.0 ? common_points(*one, *other)
                                                           : common_points_of_circles(*one, *other);
    std::optional<Vec3> nearest;
    for (const Vec3& centre : common) {
        // Paths that touch lie in one plane, nearly; the grooves part in the normal of this plane.
        Vec3 out = cross(one->direction_at(centre), other->direction_at(centre));
        if (norm(out) < 10.0 * kLeastSine) out = one->reach > 0.0 ? one->axis : other->axis;
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 at = centre + (sign * one->ball) * normalized(out);
            if (!nearest || norm(at - p) < norm(*nearest - p)) nearest = at;
        }
    }
    return nearest;
}

bool is_nearer(const Plane& one, const Plane& other, Vec3 p) {
    return std::abs(distance(one, p)) < std::abs(distance(other, p));
}

std::optional<Form> mitre_plane(const Form& a, const Form& b, Vec3 p) {
    const auto* first = std::get_if<Cylinder>(&a);
    const auto* second = std::get_if<Cylinder>(&b);
    if (const auto centre = common_circle(a, b, p)) {
        const auto axis_of_moved = [](const Form& form) -> std::optional<Vec3> {
            if (const auto* dome = std::get_if<Dome>(&form)) return dome->axis;
            if (const auto* coil = std::get_if<Coil>(&form)) return coil->axis;
            return std::nullopt;
        };
        const auto axis = axis_of_moved(a);
        return Plane{*centre, axis ? *axis : *axis_of_moved(b)};
    }
    const auto planes = first && second ? mitre_planes(*first, *second) : bend_planes(a, b);
    if (!planes) return std::nullopt;
    const auto& [one, other] = *planes;
    return is_nearer(one, other, p) ? one : other;
}

std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p) {
    const auto planes = bend_planes(a, b);
    if (!planes) return std::nullopt;
    const auto& [level, other] = *planes;
    const auto* moved = std::get_if<Extrusion>(&a);
    if (!moved) moved = std::get_if<Extrusion>(&b);
    const Vec3 side = moved->radius * normalized(cross(level.normal, other.normal));
    const Vec3 one = level.origin + side, two = level.origin - side;
    return norm(p - one) < norm(p - two) ? one : two;
}

std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 past) {
    const auto* first = std::get_if<Cylinder>(&a);
    const auto* second = std::get_if<Cylinder>(&b);
    const auto planes = first && second ? mitre_planes(*first, *second) : bend_planes(a, b);
    if (!planes) return std::nullopt;
    const auto& [one, other] = *planes;
    const auto is_on = [](const Plane& plane, Vec3 at) {
        return std::abs(distance(plane, at)) < kTangencyGapMm;
    };
    if (is_on(one, p) == is_on(one, q) || is_on(other, p) == is_on(other, q) ||
        is_on(one, p) == is_on(other, p))
        return std::nullopt;
    if (!first || !second) return corner_of_bend(a, b, is_on(one, p) ? p : q);
    // The crossings lie on the common normal of both axes.
    const Vec3 side = first->radius * normalized(cross(first->axis, second->axis));
    const Vec3 up = one.origin + side, down = one.origin - side;
    return norm(past - up) < norm(past - down) ? up : down;
}

std::optional<Form> ellipse_of_bend(const Form& a, const Form& b, Vec3 p) {
    const auto planes = bend_planes(a, b);
    if (!planes) return std::nullopt;
    const auto& [level, other] = *planes;
    if (std::abs(distance(level, p)) > kTangencyGapMm ||
        std::abs(distance(other, p)) < kTangencyGapMm)
        return std::nullopt;
    return other;
}

}  // namespace ncsim::brep
