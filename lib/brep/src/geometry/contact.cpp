// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangency of surfaces, by the kinds of both.
#include "geometry/contact.h"

#include "ncsim/base/angles.h"

#include "geometry/envelope_contact.h"
#include "geometry/path_corners.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

namespace {

std::optional<Form> plane_at(Vec3 origin, Vec3 normal) {
    return Plane{origin, normalized(normal)};
}

// Returns the place on the wall at which the outward direction is `out`.
SpiralPlace looking(const Spiral& spiral, Vec3 out) {
    const Vec3 side = cross(spiral.axis, spiral.ahead);
    SpiralPlace place = place_at(spiral, 0.0);
    double turn = angle_of(dot(out, spiral.ahead), dot(out, side)) * kRadiansPerDegree;
    for (int step = 0; step < 8; ++step) {
        place = place_at(spiral, turn);
        turn += dot(out, place.along);
    }
    return place;
}

struct Tangency {
    using Answer = std::optional<Form>;

    Answer operator()(const Plane& a, const Cylinder& b) const {
        if (!is_perpendicular(a.normal, b.axis) ||
            !is_near(std::abs(distance(a, b.origin)), b.radius))
            return {};
        return plane_at(b.origin, cross(a.normal, b.axis));
    }
    Answer operator()(const Plane& a, const Cone& b) const {
        const double sine = b.slope / std::sqrt(1.0 + b.slope * b.slope);
        const bool is_along = std::abs(std::abs(dot(a.normal, b.axis)) - sine) <= kParallelAngle;
        if (!is_along || !is_near(distance(a, b.apex), 0.0)) return {};
        return plane_at(b.apex, cross(a.normal, b.axis));
    }
    Answer operator()(const Plane& a, const Torus& b) const {
        if (!is_parallel(a.normal, b.axis) || !is_near(std::abs(distance(a, b.centre)), b.minor))
            return {};
        return Cylinder{b.centre, b.axis, b.major};
    }
    // A wall along the line, tangent to the circle.
    Answer operator()(const Plane& a, const Extrusion& b) const {
        if (!is_perpendicular(a.normal, b.along)) return {};
        const Vec3 level = a.normal - dot(a.normal, b.axis) * b.axis;
        const double support = b.radius * norm(level), deviation = distance(a, b.centre);
        if (!is_near(std::abs(deviation), support)) return {};
        const double side = deviation > 0.0 ? -b.radius : b.radius;
        return plane_at(b.centre + side * normalized(level), cross(a.normal, b.along));
    }
    Answer operator()(const Plane& a, const Dome& b) const {
        const double deviation = distance(a, b.centre);
        // The floor where the arc is level.
        if (is_parallel(a.normal, b.axis) && is_near(std::abs(deviation), b.reach))
            return Cylinder{b.centre, b.axis, b.radius};
        // A wall along the arc.
        if (is_perpendicular(a.normal, b.axis) && is_perpendicular(a.normal, b.ahead) &&
            is_near(std::abs(deviation), b.radius))
            return Cylinder{b.centre, a.normal, b.reach};
        return {};
    }
    // The cylinder at an end of the arc, where the arc is upright.
    Answer operator()(const Cylinder& a, const Dome& b) const {
        const Vec3 end = b.centre + b.reach * b.ahead;
        if (!is_parallel(a.axis, b.axis) || !is_near(a.radius, b.radius) ||
            !is_near(norm(radial_vector(a.origin, a.axis, end)), 0.0))
            return {};
        return plane_at(end, b.axis);
    }
    // The tool at rest, at a point of the path.
    Answer operator()(const Cylinder& a, const Spiral& b) const {
        if (!is_parallel(a.axis, b.axis) || !is_near(a.radius, std::abs(b.offset))) return {};
        const SpiralPlace place = project_onto(b, a.origin);
        if (!is_near(norm(radial_vector(place.path_point, b.axis, a.origin)), 0.0)) return {};
        return plane_at(place.path_point, place.along);
    }
    // A wall that continues the spiral at an end.
    Answer operator()(const Plane& a, const Spiral& b) const {
        if (!is_perpendicular(a.normal, b.axis)) return {};
        for (const double sign : {-1.0, 1.0}) {
            const SpiralPlace place = looking(b, sign * a.normal);
            const Vec3 at = place.path_point + b.offset * place.out;
            if (is_parallel(place.out, a.normal) && is_near(distance(a, at), 0.0))
                return plane_at(at, place.along);
        }
        return {};
    }
    // The walls on both sides of the path.
    Answer operator()(const Cylinder& a, const Coil& b) const {
        if (!is_parallel(a.axis, b.axis) ||
            !is_near(norm(radial_vector(b.centre, b.axis, a.origin)), 0.0) ||
            !(is_near(a.radius, b.reach + b.radius) ||
              is_near(a.radius, std::abs(b.reach - b.radius))))
            return {};
        return Helicoid{b.centre, b.axis, b.ahead, b.lead};
    }
    // A line that continues the arc.
    Answer operator()(const Extrusion& a, const Dome& b) const {
        if (!is_parallel(a.axis, b.axis) || !is_near(a.radius, b.radius)) return {};
        const double cosine = std::abs(dot(a.along, b.axis));
        const double sine =
            dot(a.along, b.axis) > 0.0 ? -dot(a.along, b.ahead) : dot(a.along, b.ahead);
        const Vec3 end = b.centre + b.reach * (cosine * b.ahead + sine * b.axis);
        if (std::abs(cosine * cosine + sine * sine - 1.0) > kParallelAngle ||
            !is_near(norm(radial_vector(a.centre, a.along, end)), 0.0))
            return {};
        return plane_at(end, b.axis);
    }
    Answer operator()(const Cylinder& a, const Cylinder& b) const {
        if (!is_parallel(a.axis, b.axis)) return {};
        const Vec3 separation = radial_vector(a.origin, a.axis, b.origin);
        const double d = norm(separation);
        if (d < kLeastAxisDistance ||
            !(is_near(d, a.radius + b.radius) || is_near(d, std::abs(a.radius - b.radius))))
            return {};
        return plane_at(a.origin, cross(a.axis, separation));
    }
    // Parallel paths whose distance is the sum or the difference of the radii.
    Answer operator()(const Extrusion& a, const Extrusion& b) const {
        if (!is_parallel(a.axis, b.axis) || !is_parallel(a.along, b.along)) return {};
        const Vec3 separation = radial_vector(a.centre, a.along, b.centre);
        const double d = norm(separation);
        if (d < kLeastAxisDistance || !is_near(dot(separation, a.axis), 0.0) ||
            !(is_near(d, a.radius + b.radius) || is_near(d, std::abs(a.radius - b.radius))))
            return {};
        return plane_at(a.centre, cross(a.along, separation));
    }
    Answer operator()(const Cylinder& a, const Sphere& b) const {
        if (!is_near(norm(radial_vector(a.origin, a.axis, b.centre)), 0.0) ||
            !is_near(a.radius, b.radius))
            return {};
        return plane_at(b.centre, a.axis);
    }
    Answer operator()(const Cylinder& a, const Torus& b) const {
        if (is_parallel(a.axis, b.axis)) {
            const bool same = is_near(norm(radial_vector(a.origin, a.axis, b.centre)), 0.0);
            if (same &&
                (is_near(a.radius, b.major + b.minor) || is_near(a.radius, b.major - b.minor)))
                return plane_at(b.centre, b.axis);
            return {};
        }
        // A cylinder that continues the tube of the torus.
        if (!is_perpendicular(a.axis, b.axis) || !is_near(a.radius, b.minor)) return {};
        const Vec3 separation = radial_vector(a.origin, a.axis, b.centre);
        if (!is_near(norm(separation), b.major) || !is_near(dot(separation, b.axis), 0.0))
            return {};
        return plane_at(b.centre, a.axis);
    }
    Answer operator()(const Cone& a, const Cone& b) const {
        if (!is_parallel(a.axis, b.axis) || std::abs(a.slope - b.slope) > kParallelAngle) return {};
        const Vec3 separation = radial_vector(a.apex, a.axis, b.apex);
        const double height = std::abs(dot(b.apex - a.apex, a.axis));
        if (norm(separation) < kLeastAxisDistance || !is_near(norm(separation), a.slope * height))
            return {};
        return plane_at(a.apex, cross(a.axis, separation));
    }
    Answer operator()(const Cone& a, const Sphere& b) const {
        return round_end(a, b.centre, 0.0, b.radius);
    }
    Answer operator()(const Cone& a, const Torus& b) const {
        if (!is_parallel(a.axis, b.axis)) return {};
        return round_end(a, b.centre, b.major, b.minor);
    }
    Answer operator()(const Sphere& a, const Torus& b) const {
        const Vec3 separation = a.centre - b.centre;
        if (!is_near(a.radius, b.minor) || !is_near(dot(separation, b.axis), 0.0) ||
            !is_near(norm(separation), b.major))
            return {};
        return plane_at(b.centre, cross(b.axis, separation));
    }
    Answer operator()(const Torus& a, const Torus& b) const {
        if (!is_parallel(a.axis, b.axis)) return common_tube(a, b);
        const Vec3 separation = b.centre - a.centre;
        const double d = norm(separation);
        if (!is_near(a.minor, b.minor) || d < kLeastAxisDistance ||
            !is_near(dot(separation, a.axis), 0.0))
            return {};
        if (!is_near(d, a.major + b.major) && !is_near(d, std::abs(a.major - b.major))) return {};
        return plane_at(a.centre, cross(a.axis, separation));
    }
    template <typename A>
    Answer operator()(const A& a, const Envelope& b) const {
        return envelope_tangency_surface(a, b);
    }
    template <typename A, typename B>
    Answer operator()(const A&, const B&) const {
        return {};
    }

private:
    // Returns the plane of the circle that two tubes have in common where one goes over into the
    // other: their lines of centres touch.
    static Answer common_tube(const Torus& a, const Torus& b) {
        if (!is_near(a.minor, b.minor)) return {};
        const Vec3 along = normalized(cross(a.axis, b.axis));
        const Vec3 out = a.major * cross(along, a.axis), other = b.major * cross(along, b.axis);
        for (const double sign : {-1.0, 1.0}) {
            for (const double second : {-1.0, 1.0}) {
                const Vec3 at = a.centre + sign * out;
                if (is_near(norm(at - b.centre - second * other), 0.0)) return plane_at(at, along);
            }
        }
        return {};
    }

    // Returns the plane of tangency of a cone with a tube about the cone's axis.
    static Answer round_end(const Cone& a, Vec3 centre, double major, double minor) {
        if (!is_near(norm(radial_vector(a.apex, a.axis, centre)), 0.0)) return {};
        const double cosine = 1.0 / std::sqrt(1.0 + a.slope * a.slope);
        const double sine = a.slope * cosine;
        const double height = dot(centre - a.apex, a.axis);
        const double d = major * cosine - height * sine;
        if (!is_near(std::abs(d), minor)) return {};
        return plane_at(a.apex + (height + d * sine) * a.axis, a.axis);
    }
};

}  // namespace

std::optional<Form> tangency_surface(const Form& a, const Form& b) {
    return a.index() <= b.index() ? std::visit(Tangency{}, a, b) : std::visit(Tangency{}, b, a);
}

std::optional<Form> corner_of_dome(std::span<const Form* const> forms) {
    for (const Form* form : forms) {
        const auto* dome = std::get_if<Dome>(form);
        if (!dome) continue;
        bool has_floor = false, has_wall = false;
        for (const Form* other : forms) {
            const auto* plane = std::get_if<Plane>(other);
            if (!plane || !tangency_surface(*plane, *dome)) continue;
            (is_parallel(plane->normal, dome->axis) ? has_floor : has_wall) = true;
        }
        if (has_floor && has_wall) return Plane{dome->centre, dome->ahead};
    }
    return std::nullopt;
}

std::vector<Form> level_tangency_planes(std::span<const Form* const> forms) {
    struct LevelCircle {
        Vec3 centre;
        double radius;
        bool moves;
    };
    std::vector<Form> planes;
    for (const Form* form : forms) {
        const auto* level = std::get_if<Plane>(form);
        if (!level) continue;
        std::vector<LevelCircle> circles;
        std::vector<const Plane*> walls;
        for (const Form* other : forms) {
            if (const auto* wall = std::get_if<Plane>(other)) {
                if (is_perpendicular(wall->normal, level->normal)) walls.push_back(wall);
            } else if (const auto* f = std::get_if<Dome>(other)) {
                if (is_parallel(f->axis, level->normal))
                    circles.push_back({centre_at_height(*f, level->origin), f->radius, true});
            } else if (const auto* coil = std::get_if<Coil>(other)) {
                if (is_parallel(coil->axis, level->normal))
                    circles.push_back(
                        {place_at_height(*coil, level->origin).centre, coil->radius, true});
            } else if (const auto moved = moved_circle(*other, level->normal)) {
                if (!is_parallel(moved->axis, level->normal)) continue;
                const double lean = dot(moved->along, level->normal);
                circles.push_back(
                    {moved->centre - (distance(*level, moved->centre) / lean) * moved->along,
                     moved->radius, std::holds_alternative<Extrusion>(*other)});
            }
        }
        for (std::size_t i = 0; i < circles.size(); ++i) {
            for (std::size_t j = i + 1; j < circles.size(); ++j) {
                const LevelCircle &a = circles[i], &b = circles[j];
                const Vec3 separation = radial_vector(a.centre, level->normal, b.centre);
                const double d = norm(separation);
                if ((!a.moves && !b.moves) || d < kLeastAxisDistance) continue;
                if (is_near(d, a.radius + b.radius) || is_near(d, std::abs(a.radius - b.radius)))
                    planes.push_back(Plane{a.centre, normalized(cross(level->normal, separation))});
            }
            for (const Plane* wall : walls) {
                if (circles[i].moves &&
                    is_near(std::abs(distance(*wall, circles[i].centre)), circles[i].radius))
                    planes.push_back(
                        Plane{circles[i].centre, normalized(cross(level->normal, wall->normal))});
            }
        }
    }
    return planes;
}

std::optional<Form> tangency_surface_at(const Form& a, const Form& b, Vec3 p, Vec3 q) {
    auto touching = tangency_surface(a, b);
    const double most = std::sqrt(8.0 * std::max(radius_of(a), radius_of(b)) * kTangencyGapMm);
    const auto is_there = [&](Vec3 at) { return std::abs(distance(*touching, at)) <= most; };
    if (touching && !(is_there(p) && is_there(q))) touching.reset();
    return touching;
}

}  // namespace ncsim::brep
