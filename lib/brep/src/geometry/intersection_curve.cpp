// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection curves of surfaces that have a name: lines, circles and ellipses.
#include "geometry/contact.h"
#include "geometry/path_corners.h"
#include "geometry/plane_cut.h"
#include "geometry/rim.h"
#include "geometry/tolerances.h"

#include <cmath>

namespace ncsim::brep {

namespace {

struct Axis {
    Vec3 origin, direction;
};

std::optional<Axis> axis_of(const Form& form) {
    if (const auto* f = std::get_if<Cylinder>(&form)) return Axis{f->origin, f->axis};
    if (const auto* f = std::get_if<Cone>(&form)) return Axis{f->apex, f->axis};
    if (const auto* f = std::get_if<Torus>(&form)) return Axis{f->centre, f->axis};
    return std::nullopt;
}

// Returns the axis about which both forms are surfaces of revolution.
std::optional<Axis> common_axis(const Form& a, const Form& b) {
    const auto first = axis_of(a), second = axis_of(b);
    const auto* plane = std::get_if<Plane>(&b);
    const auto* sphere = std::get_if<Sphere>(&b);
    if (first && second) {
        if (is_parallel(first->direction, second->direction) &&
            is_near(norm(radial_vector(first->origin, first->direction, second->origin)), 0.0))
            return first;
        return std::nullopt;
    }
    if (second) return common_axis(b, a);
    if (first && plane) return is_parallel(first->direction, plane->normal) ? first : std::nullopt;
    if (first && sphere) {
        const Vec3 separation = radial_vector(first->origin, first->direction, sphere->centre);
        return is_near(norm(separation), 0.0) ? first : std::nullopt;
    }
    if (const auto* other = std::get_if<Sphere>(&a)) {
        if (plane) return Axis{other->centre, plane->normal};
        if (sphere && norm(sphere->centre - other->centre) > kLeastAxisDistance)
            return Axis{other->centre, normalized(sphere->centre - other->centre)};
        return std::nullopt;
    }
    return sphere ? common_axis(b, a) : std::nullopt;
}

// Returns the circle about `axis` through `p`. If `p` misses a cylinder by less than the tolerance
// of CAD readers, the circle has the cylinder's radius. A circle that ends at an angle to another
// edge must end in the corner itself.
Curve circle_about(const Axis& axis, Vec3 p, const Form& a, const Form& b) {
    const Vec3 centre = axis.origin + dot(p - axis.origin, axis.direction) * axis.direction;
    double radius = norm(p - centre);
    for (const Form* form : {&a, &b}) {
        const auto* wall = std::get_if<Cylinder>(form);
        if (wall && std::abs(wall->radius - radius) <= 2.0 * kReaderMm) radius = wall->radius;
    }
    return Circle{centre, axis.direction, radius};
}

// Returns the meridian of a torus in a plane through the axis.
Curve meridian(const Torus& torus, Vec3 normal, Vec3 p) {
    const Vec3 out = radial_vector(torus.centre, torus.axis, p);
    const Vec3 in_plane = normalized(out - dot(out, normal) * normal);
    return Circle{torus.centre + torus.major * in_plane, normal, torus.minor};
}

Curve ellipse(const Plane& plane, const Extrusion& extrusion) {
    const PlaneCut cut(extrusion, {plane.normal, dot(plane.normal, plane.origin)});
    const auto [centre, x, y] = *cut.exact(0);
    // CAD readers begin an ellipse at the longer axis; rounding may exchange the axes.
    if (std::abs(norm(x) - norm(y)) <= kRounding) return Circle{centre, plane.normal, norm(x)};
    return Ellipse{centre, plane.normal, normalized(x), norm(x), norm(y)};
}

Curve ellipse(const Plane& plane, const Cylinder& cylinder) {
    const double lean = dot(plane.normal, cylinder.axis);
    const double height = dot(plane.normal, cylinder.origin - plane.origin) / lean;
    const Vec3 minor = normalized(cross(plane.normal, cylinder.axis));
    return Ellipse{cylinder.origin - height * cylinder.axis, plane.normal,
                   cross(minor, plane.normal), cylinder.radius / std::abs(lean), cylinder.radius};
}

// Returns the curve of a dome and a second form, through `p` and `q`. Where the tool crosses its
// own path, the curve may end on a common circle without following the circle; `near_to` decides.
std::optional<Curve> intersection_curve(const Dome& dome, const Form& other, Vec3 p, Vec3 q,
                                        Vec3 near_to) {
    if (const auto* plane = std::get_if<Plane>(&other)) {
        const bool is_level = is_parallel(plane->normal, dome.axis);
        if (tangency_surface(other, dome)) {
            const Vec3 centre = dome.centre - distance(other, dome.centre) * plane->normal;
            return Circle{centre, plane->normal, is_level ? dome.radius : dome.reach};
        }
        if (!is_level) return std::nullopt;
        return Circle{centre_at_height(dome, plane->origin), dome.axis, dome.radius};
    }
    const auto centre = common_circle(dome, other, p);
    const auto is_level = [&](Vec3 at) { return is_near(dot(at - *centre, dome.axis), 0.0); };
    if (!centre || !is_level(p) || !is_level(q)) return std::nullopt;
    if (!belongs_to_circle(dome, *centre, near_to)) return std::nullopt;
    return Circle{*centre, dome.axis, dome.radius};
}

std::optional<Curve> intersection_curve(const Coil& coil, const Form& other, Vec3 p, Vec3 q,
                                        Vec3 near_to) {
    const auto is_level = [&](Vec3 a, Vec3 b) { return is_near(dot(a - b, coil.axis), 0.0); };
    if (const auto* plane = std::get_if<Plane>(&other)) {
        if (!is_parallel(plane->normal, coil.axis)) return std::nullopt;
        return Circle{place_at_height(coil, plane->origin).centre, coil.axis, coil.radius};
    }
    const auto centre = common_circle(coil, other, p);
    if (!centre || !is_level(p, *centre) || !is_level(q, *centre)) return std::nullopt;
    if (!belongs_to_circle(coil, *centre, near_to)) return std::nullopt;
    return Circle{*centre, coil.axis, coil.radius};
}

// True if the form is parallel to `axis`.
bool is_upright(const Form& form, Vec3 axis) {
    if (const auto* plane = std::get_if<Plane>(&form)) return is_perpendicular(plane->normal, axis);
    if (const auto* cylinder = std::get_if<Cylinder>(&form))
        return is_parallel(cylinder->axis, axis);
    const auto* spiral = std::get_if<Spiral>(&form);
    return spiral && is_parallel(spiral->axis, axis);
}

// Returns the curve of a spiral and a second form: a line along the axis, or no value.
std::optional<Curve> intersection_curve(const Spiral& spiral, const Form& other) {
    if (is_upright(other, spiral.axis)) return Line{};
    return std::nullopt;
}

// Returns the direction of the rulings of `form`, if the rulings are parallel.
std::optional<Vec3> ruling_of(const Form& form) {
    if (const auto* f = std::get_if<Cylinder>(&form)) return f->axis;
    if (const auto* f = std::get_if<Extrusion>(&form)) return f->along;
    if (const auto* f = std::get_if<Envelope>(&form)) {
        const auto* line = std::get_if<StraightPath>(&f->sweep->path());
        if (line) return normalized(line->along);
    }
    return std::nullopt;
}

// Returns the curve of an envelope and a second form: the circle of a ball at rest, or a ruling of
// an envelope on a straight path.
std::optional<Curve> intersection_curve(const Envelope& envelope, const Form& other) {
    if (const auto along = ruling_of(envelope)) {
        const auto* plane = std::get_if<Plane>(&other);
        const auto other_ruling = ruling_of(other);
        if ((plane && is_perpendicular(plane->normal, *along)) ||
            (other_ruling && is_parallel(*other_ruling, *along)))
            return Line{};
    }
    if (!envelope.sweep->is_ball()) return std::nullopt;
    const auto touching = tangency_surface(envelope, other);
    const auto* across = touching ? std::get_if<Plane>(&*touching) : nullptr;
    if (!across) return std::nullopt;
    return Circle{across->origin, across->normal, envelope.sweep->fillet()->radius};
}

// Returns the circle of a rim at rest, if the whole circle lies on both forms and `p` and `q` lie
// on the circle.
std::optional<Curve> circle_of_rim(const Envelope& envelope, const Form& other, Vec3 p, Vec3 q) {
    const Sweep& sweep = *envelope.sweep;
    if (!sweep.is_rim()) return std::nullopt;
    for (const double t : {0.0, 1.0}) {
        const ToolFrame at = sweep.at(t);
        const PathFrame middle = path_frame(sweep, at);
        const double radius = sweep.fillet()->centre_radius;
        const auto is_on = [&](Vec3 v) {
            return std::abs(dot(v - middle.centre, at.axis)) <= kTangencyGapMm &&
                   std::abs(norm(v - middle.centre) - radius) <= kTangencyGapMm;
        };
        const Vec3 out = cross(middle.side, at.axis);
        const auto is_of_other = [&](Vec3 direction) {
            return std::abs(distance(other, middle.centre + radius * direction)) <= kTangencyGapMm;
        };
        if (is_on(p) && is_on(q) && is_of_other(middle.side) && is_of_other(-middle.side) &&
            is_of_other(out) && is_of_other(-out))
            return Circle{middle.centre, at.axis, radius};
    }
    return std::nullopt;
}

bool is_ruled(const Form& form) {
    return std::holds_alternative<Plane>(form) || std::holds_alternative<Cylinder>(form) ||
           std::holds_alternative<Cone>(form) || std::holds_alternative<Extrusion>(form);
}

}  // namespace

std::optional<Curve> intersection_curve(const Form& a, const Form& b, Vec3 p, Vec3 q,
                                        Vec3 near_to) {
    if (const auto axis = common_axis(a, b)) return circle_about(*axis, p, a, b);
    if (const auto* coil = std::get_if<Coil>(&a))
        return intersection_curve(*coil, b, p, q, near_to);
    if (const auto* coil = std::get_if<Coil>(&b))
        return intersection_curve(*coil, a, p, q, near_to);
    for (const auto& [form, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        const auto* envelope = std::get_if<Envelope>(form);
        auto circle = envelope ? circle_of_rim(*envelope, *other, p, q) : std::nullopt;
        if (circle) return circle;
    }
    if (const auto* envelope = std::get_if<Envelope>(&a)) return intersection_curve(*envelope, b);
    if (const auto* envelope = std::get_if<Envelope>(&b)) return intersection_curve(*envelope, a);
    if (const auto* spiral = std::get_if<Spiral>(&a)) return intersection_curve(*spiral, b);
    if (const auto* spiral = std::get_if<Spiral>(&b)) return intersection_curve(*spiral, a);
    if (const auto* dome = std::get_if<Dome>(&a))
        return intersection_curve(*dome, b, p, q, near_to);
    if (const auto* dome = std::get_if<Dome>(&b))
        return intersection_curve(*dome, a, p, q, near_to);
    const bool is_first_plane = std::holds_alternative<Plane>(a);
    const bool is_second_plane = std::holds_alternative<Plane>(b);
    if (is_first_plane && is_second_plane) return Line{};
    if (is_ruled(a) && is_ruled(b) && tangency_surface(a, b)) return Line{};
    if (const auto touching = tangency_surface_at(a, b, p, q)) {
        for (const Form* form : {&a, &b}) {
            if (const auto* pipe = std::get_if<Cylinder>(form))
                return circle_about({pipe->origin, pipe->axis}, p, a, b);
        }
        for (const Form* form : {&a, &b}) {
            const auto* plane = std::get_if<Plane>(&*touching);
            if (const auto* torus = std::get_if<Torus>(form); torus && plane)
                return meridian(*torus, plane->normal, p);
        }
        return std::nullopt;
    }
    const auto* first = std::get_if<Cylinder>(&a);
    const auto* second = std::get_if<Cylinder>(&b);
    if (first && second) {
        if (is_parallel(first->axis, second->axis)) return Line{};
        const auto planes = mitre_planes(*first, *second);
        if (!planes) return std::nullopt;
        const auto is_on = [&](const Plane& plane) {
            return std::abs(distance(plane, p)) < kTangencyGapMm &&
                   std::abs(distance(plane, q)) < kTangencyGapMm;
        };
        const auto& [one, other] = *planes;
        if (!is_on(one) && !is_on(other)) return std::nullopt;
        // Both ellipses pass through the points where the pipes are tangent.
        const bool is_first = is_on(one) && (!is_on(other) || is_nearer(one, other, near_to));
        return ellipse(is_first ? one : other, *first);
    }
    if (const auto planes = bend_planes(a, b)) {
        const auto is_on = [&](const Plane& plane) {
            return std::abs(distance(plane, p)) < kTangencyGapMm &&
                   std::abs(distance(plane, q)) < kTangencyGapMm;
        };
        const auto& [level, other] = *planes;
        if (!is_on(level) && !is_on(other)) return std::nullopt;
        const bool is_level = is_on(level) && (!is_on(other) || is_nearer(level, other, near_to));
        const auto* moved = std::get_if<Extrusion>(&a);
        if (!moved) moved = std::get_if<Extrusion>(&b);
        if (is_level) return Circle{level.origin, level.normal, moved->radius};
        return ellipse(other, *moved);
    }
    if (!is_first_plane && !is_second_plane) return std::nullopt;
    const auto& plane = std::get<Plane>(is_first_plane ? a : b);
    const Form& other = is_first_plane ? b : a;
    if (const auto* f = std::get_if<Cylinder>(&other)) {
        const double lean = std::abs(dot(plane.normal, f->axis));
        if (lean <= kParallelAngle) return Line{};
        // CAD readers draw nothing of an ellipse that is metres long.
        if (lean < 10.0 * kLeastSine) return std::nullopt;
        return ellipse(plane, *f);
    }
    if (const auto* f = std::get_if<Extrusion>(&other)) {
        if (is_perpendicular(plane.normal, f->along)) return Line{};
        if (is_parallel(plane.normal, f->axis)) {
            const double height = dot(plane.normal, plane.origin - f->centre);
            const Vec3 centre = f->centre + (height / dot(plane.normal, f->along)) * f->along;
            return Circle{centre, f->axis, f->radius};
        }
        return ellipse(plane, *f);
    }
    if (const auto* f = std::get_if<Torus>(&other)) {
        if (is_perpendicular(plane.normal, f->axis) && std::abs(distance(plane, f->centre)) < 1e-7)
            return meridian(*f, plane.normal, p);
    }
    if (std::holds_alternative<Cone>(other)) {
        // Rulings pass through the apex.
        const Vec3 middle = 0.5 * (p + q);
        if (norm(q - p) > kTangencyGapMm &&
            std::abs(distance(plane, std::get<Cone>(other).apex)) < kRounding &&
            std::abs(distance(other, middle)) < kRounding)
            return Line{};
    }
    return std::nullopt;
}

}  // namespace ncsim::brep
