// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact.h"

#include "ncsim/trig/angles.h"

#include "plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

constexpr double kParallel = 1e-5;  // rad
// Axes nearer than this are one, or nothing can be said of them, mm.
constexpr double kApart = 0.01;

bool is_parallel(Vec3 a, Vec3 b) {
    return norm(cross(a, b)) <= kParallel;
}
bool is_across(Vec3 a, Vec3 b) {
    return std::abs(dot(a, b)) <= kParallel;
}
bool near(double a, double b) {
    return std::abs(a - b) <= kTouchMm;
}
// From the axis to the point, at right angles.
Vec3 away(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    return v - dot(v, axis) * axis;
}

std::optional<Form> plane_at(Vec3 origin, Vec3 normal) {
    return Plane{origin, normalized(normal)};
}

// The place of the wall whose direction outwards is `out`.
SpiralPlace looking(const Spiral& spiral, Vec3 out) {
    const Vec3 side = cross(spiral.axis, spiral.ahead);
    SpiralPlace place = place_at(spiral, 0.0);
    constexpr int kSteps = 8;
    double turn = trig::angle_of(dot(out, spiral.ahead), dot(out, side)) * trig::kRadiansPerDegree;
    for (int step = 0; step < kSteps; ++step) {
        place = place_at(spiral, turn);
        turn += dot(out, place.along);
    }
    return place;
}

struct Touch {
    using Answer = std::optional<Form>;

    Answer operator()(const Plane& a, const Cylinder& b) const {
        if (!is_across(a.normal, b.axis) || !near(std::abs(distance(a, b.origin)), b.radius))
            return {};
        return plane_at(b.origin, cross(a.normal, b.axis));
    }
    Answer operator()(const Plane& a, const Cone& b) const {
        const double sine = b.slope / std::sqrt(1.0 + b.slope * b.slope);
        const bool is_along = std::abs(std::abs(dot(a.normal, b.axis)) - sine) <= kParallel;
        if (!is_along || !near(distance(a, b.apex), 0.0)) return {};
        return plane_at(b.apex, cross(a.normal, b.axis));
    }
    Answer operator()(const Plane& a, const Torus& b) const {
        if (!is_parallel(a.normal, b.axis) || !near(std::abs(distance(a, b.centre)), b.minor))
            return {};
        return Cylinder{b.centre, b.axis, b.major};
    }
    // A wall along the line, at the end of its way across.
    Answer operator()(const Plane& a, const Extrusion& b) const {
        if (!is_across(a.normal, b.along)) return {};
        const Vec3 level = a.normal - dot(a.normal, b.axis) * b.axis;
        const double support = b.radius * norm(level), off = distance(a, b.centre);
        if (!near(std::abs(off), support)) return {};
        const double side = off > 0.0 ? -b.radius : b.radius;
        return plane_at(b.centre + side * normalized(level), cross(a.normal, b.along));
    }
    Answer operator()(const Plane& a, const Dome& b) const {
        const double off = distance(a, b.centre);
        // Where the arc is level.
        if (is_parallel(a.normal, b.axis) && near(std::abs(off), b.reach))
            return Cylinder{b.centre, b.axis, b.radius};
        // A wall beside the arc.
        if (is_across(a.normal, b.axis) && is_across(a.normal, b.ahead) &&
            near(std::abs(off), b.radius))
            return Cylinder{b.centre, a.normal, b.reach};
        return {};
    }
    // The arc ends upright.
    Answer operator()(const Cylinder& a, const Dome& b) const {
        const Vec3 end = b.centre + b.reach * b.ahead;
        if (!is_parallel(a.axis, b.axis) || !near(a.radius, b.radius) ||
            !near(norm(away(a.origin, a.axis, end)), 0.0))
            return {};
        return plane_at(end, b.axis);
    }
    // Where the tool stood, on the way.
    Answer operator()(const Cylinder& a, const Spiral& b) const {
        if (!is_parallel(a.axis, b.axis) || !near(a.radius, std::abs(b.offset))) return {};
        const SpiralPlace place = place_on(b, a.origin);
        if (!near(norm(away(place.way, b.axis, a.origin)), 0.0)) return {};
        return plane_at(place.way, place.along);
    }
    // A wall goes on from its end.
    Answer operator()(const Plane& a, const Spiral& b) const {
        if (!is_across(a.normal, b.axis)) return {};
        for (const double sign : {-1.0, 1.0}) {
            const SpiralPlace place = looking(b, sign * a.normal);
            const Vec3 at = place.way + b.offset * place.out;
            if (is_parallel(place.out, a.normal) && near(distance(a, at), 0.0))
                return plane_at(at, place.along);
        }
        return {};
    }
    // The walls on both sides of the way.
    Answer operator()(const Cylinder& a, const Coil& b) const {
        if (!is_parallel(a.axis, b.axis) || !near(norm(away(b.centre, b.axis, a.origin)), 0.0) ||
            !(near(a.radius, b.reach + b.radius) || near(a.radius, std::abs(b.reach - b.radius))))
            return {};
        return Helicoid{b.centre, b.axis, b.ahead, b.lead};
    }
    // The arc goes on as a line.
    Answer operator()(const Extrusion& a, const Dome& b) const {
        if (!is_parallel(a.axis, b.axis) || !near(a.radius, b.radius)) return {};
        const double cosine = std::abs(dot(a.along, b.axis));
        const double sine =
            dot(a.along, b.axis) > 0.0 ? -dot(a.along, b.ahead) : dot(a.along, b.ahead);
        const Vec3 end = b.centre + b.reach * (cosine * b.ahead + sine * b.axis);
        if (std::abs(cosine * cosine + sine * sine - 1.0) > kParallel ||
            !near(norm(away(a.centre, a.along, end)), 0.0))
            return {};
        return plane_at(end, b.axis);
    }
    Answer operator()(const Cylinder& a, const Cylinder& b) const {
        if (!is_parallel(a.axis, b.axis)) return {};
        const Vec3 apart = away(a.origin, a.axis, b.origin);
        const double d = norm(apart);
        if (d < kApart || !(near(d, a.radius + b.radius) || near(d, std::abs(a.radius - b.radius))))
            return {};
        return plane_at(a.origin, cross(a.axis, apart));
    }
    Answer operator()(const Cylinder& a, const Sphere& b) const {
        if (!near(norm(away(a.origin, a.axis, b.centre)), 0.0) || !near(a.radius, b.radius))
            return {};
        return plane_at(b.centre, a.axis);
    }
    Answer operator()(const Cylinder& a, const Torus& b) const {
        if (is_parallel(a.axis, b.axis)) {
            const bool same = near(norm(away(a.origin, a.axis, b.centre)), 0.0);
            if (same && (near(a.radius, b.major + b.minor) || near(a.radius, b.major - b.minor)))
                return plane_at(b.centre, b.axis);
            return {};
        }
        // The ring goes on as a pipe.
        if (!is_across(a.axis, b.axis) || !near(a.radius, b.minor)) return {};
        const Vec3 apart = away(a.origin, a.axis, b.centre);
        if (!near(norm(apart), b.major) || !near(dot(apart, b.axis), 0.0)) return {};
        return plane_at(b.centre, a.axis);
    }
    Answer operator()(const Cone& a, const Cone& b) const {
        if (!is_parallel(a.axis, b.axis) || std::abs(a.slope - b.slope) > kParallel) return {};
        const Vec3 apart = away(a.apex, a.axis, b.apex);
        const double height = std::abs(dot(b.apex - a.apex, a.axis));
        if (norm(apart) < kApart || !near(norm(apart), a.slope * height)) return {};
        return plane_at(a.apex, cross(a.axis, apart));
    }
    Answer operator()(const Cone& a, const Sphere& b) const {
        return round_end(a, b.centre, 0.0, b.radius);
    }
    Answer operator()(const Cone& a, const Torus& b) const {
        if (!is_parallel(a.axis, b.axis)) return {};
        return round_end(a, b.centre, b.major, b.minor);
    }
    Answer operator()(const Sphere& a, const Torus& b) const {
        const Vec3 apart = a.centre - b.centre;
        if (!near(a.radius, b.minor) || !near(dot(apart, b.axis), 0.0) ||
            !near(norm(apart), b.major))
            return {};
        return plane_at(b.centre, cross(b.axis, apart));
    }
    Answer operator()(const Torus& a, const Torus& b) const {
        const Vec3 apart = b.centre - a.centre;
        const double d = norm(apart);
        if (!is_parallel(a.axis, b.axis) || !near(a.minor, b.minor) || d < kApart ||
            !near(dot(apart, a.axis), 0.0))
            return {};
        if (!near(d, a.major + b.major) && !near(d, std::abs(a.major - b.major))) return {};
        return plane_at(a.centre, cross(a.axis, apart));
    }
    template <typename A, typename B>
    Answer operator()(const A&, const B&) const {
        return {};
    }

private:
    // A tube about the axis of a cone, and the cone.
    static Answer round_end(const Cone& a, Vec3 centre, double major, double minor) {
        if (!near(norm(away(a.apex, a.axis, centre)), 0.0)) return {};
        const double cosine = 1.0 / std::sqrt(1.0 + a.slope * a.slope);
        const double sine = a.slope * cosine;
        const double height = dot(centre - a.apex, a.axis);
        const double d = major * cosine - height * sine;
        if (!near(std::abs(d), minor)) return {};
        return plane_at(a.apex + (height + d * sine) * a.axis, a.axis);
    }
};

struct Axis {
    Vec3 origin, direction;
};

std::optional<Axis> axis_of(const Form& form) {
    if (const auto* f = std::get_if<Cylinder>(&form)) return Axis{f->origin, f->axis};
    if (const auto* f = std::get_if<Cone>(&form)) return Axis{f->apex, f->axis};
    if (const auto* f = std::get_if<Torus>(&form)) return Axis{f->centre, f->axis};
    return std::nullopt;
}

// About which both turn into themselves.
std::optional<Axis> common_axis(const Form& a, const Form& b) {
    const auto first = axis_of(a), second = axis_of(b);
    const auto* plane = std::get_if<Plane>(&b);
    const auto* sphere = std::get_if<Sphere>(&b);
    if (first && second) {
        if (is_parallel(first->direction, second->direction) &&
            near(norm(away(first->origin, first->direction, second->origin)), 0.0))
            return first;
        return std::nullopt;
    }
    if (second) return common_axis(b, a);
    if (first && plane) return is_parallel(first->direction, plane->normal) ? first : std::nullopt;
    if (first && sphere) {
        const Vec3 apart = away(first->origin, first->direction, sphere->centre);
        return near(norm(apart), 0.0) ? first : std::nullopt;
    }
    if (const auto* other = std::get_if<Sphere>(&a)) {
        if (plane) return Axis{other->centre, plane->normal};
        if (sphere && norm(sphere->centre - other->centre) > kApart)
            return Axis{other->centre, normalized(sphere->centre - other->centre)};
        return std::nullopt;
    }
    return sphere ? common_axis(b, a) : std::nullopt;
}

Curve circle_about(Vec3 origin, Vec3 direction, Vec3 p) {
    const Vec3 centre = origin + dot(p - origin, direction) * direction;
    return Circle{centre, direction, norm(p - centre)};
}

// The circle of a ring in a plane through its axis.
Curve meridian(const Torus& torus, Vec3 normal, Vec3 p) {
    const Vec3 out = away(torus.centre, torus.axis, p);
    const Vec3 in_plane = normalized(out - dot(out, normal) * normal);
    return Circle{torus.centre + torus.major * in_plane, normal, torus.minor};
}

Curve ellipse(const Plane& plane, const Extrusion& extrusion) {
    const PlaneCut cut(extrusion, {plane.normal, dot(plane.normal, plane.origin)});
    const auto [centre, x, y] = *cut.exact(0);
    return Ellipse{centre, plane.normal, normalized(x), norm(x), norm(y)};
}

Curve ellipse(const Plane& plane, const Cylinder& cylinder) {
    const double lean = dot(plane.normal, cylinder.axis);
    const double height = dot(plane.normal, cylinder.origin - plane.origin) / lean;
    const Vec3 minor = normalized(cross(plane.normal, cylinder.axis));
    return Ellipse{cylinder.origin - height * cylinder.axis, plane.normal,
                   cross(minor, plane.normal), cylinder.radius / std::abs(lean), cylinder.radius};
}

// Cylinders of one radius whose axes cross meet in two ellipses, in the planes between the axes.
std::optional<std::array<Plane, 2>> mitres(const Cylinder& a, const Cylinder& b) {
    constexpr double kEqual = 1e-6, kLeastAngle = 3e-5;
    const Vec3 normal = cross(a.axis, b.axis);
    if (std::abs(a.radius - b.radius) > kEqual || norm(normal) < kLeastAngle) return std::nullopt;
    if (std::abs(dot(b.origin - a.origin, normal)) > kEqual * norm(normal)) return std::nullopt;
    // The point of the first axis on the plane of the second one and the normal.
    const Vec3 side = cross(normal, b.axis);
    const Vec3 centre = a.origin + (dot(b.origin - a.origin, side) / dot(a.axis, side)) * a.axis;
    return {
        {Plane{centre, normalized(a.axis - b.axis)}, Plane{centre, normalized(a.axis + b.axis)}}};
}

// Of level circles of one radius that move along lines the one where the lines cross, and the plane
// of the ellipse in which the circles of every height meet. A cylinder moves along its axis.
std::optional<std::array<Plane, 2>> bends(const Extrusion& a, const Extrusion& b) {
    constexpr double kEqual = 1e-6, kLeastAngle = 3e-5;
    if (std::abs(a.radius - b.radius) > kEqual || !is_parallel(a.axis, b.axis)) return std::nullopt;
    // How far apart they are where the first has its centre, and how much farther 1 mm above.
    const auto lean = [&](const Extrusion& e) { return (1.0 / dot(e.along, a.axis)) * e.along; };
    const Vec3 first = lean(a), second = lean(b), drift = second - first;
    const Vec3 apart = b.centre + dot(a.centre - b.centre, a.axis) * second - a.centre;
    const double length = norm(drift);
    if (length < kLeastAngle || norm(cross(apart, drift)) > kEqual * length) return std::nullopt;
    const Vec3 centre = a.centre - (dot(apart, drift) / (length * length)) * first;
    return {{Plane{centre, a.axis},
             Plane{centre, normalized(cross(first + second, cross(a.axis, drift)))}}};
}

std::optional<Extrusion> moved_circle(const Form& form, Vec3 axis) {
    if (const auto* f = std::get_if<Extrusion>(&form)) return *f;
    const auto* f = std::get_if<Cylinder>(&form);
    if (!f || !is_parallel(f->axis, axis)) return std::nullopt;
    return Extrusion{f->origin, axis, axis, f->radius};
}

std::optional<std::array<Plane, 2>> bends(const Form& a, const Form& b) {
    const auto* one = std::get_if<Extrusion>(&a);
    const auto* other = std::get_if<Extrusion>(&b);
    if (!one && !other) return std::nullopt;
    const Vec3 axis = one ? one->axis : other->axis;
    const auto first = moved_circle(a, axis), second = moved_circle(b, axis);
    return first && second ? bends(*first, *second) : std::nullopt;
}

// Where the circle of a dome and one of the same size that moves along a line are one: the centre
// nearest to the height of `p`.
std::optional<Vec3> common_circle(const Dome& dome, const Form& other, Vec3 p) {
    constexpr double kEqual = 1e-6;
    const auto moved = moved_circle(other, dome.axis);
    if (!moved || std::abs(moved->radius - dome.radius) > kEqual ||
        !is_parallel(moved->axis, dome.axis))
        return std::nullopt;
    const Vec3 side = cross(dome.axis, dome.ahead), v = moved->centre - dome.centre;
    if (std::abs(dot(moved->along, side)) > kParallel || !near(dot(v, side), 0.0))
        return std::nullopt;
    // Of the line the point nearest to the arc's centre, and from there to the arc.
    const Vec3 nearest = v - dot(v, moved->along) * moved->along;
    const double off = norm(nearest);
    if (off > dome.reach + kTouchMm) return std::nullopt;
    const double half = std::sqrt(std::max(0.0, dome.reach * dome.reach - off * off));
    std::optional<Vec3> best;
    for (const double sign : {-1.0, 1.0}) {
        const Vec3 centre = nearest + (sign * half) * moved->along;
        if (dot(centre, dome.ahead) < -kTouchMm) continue;
        const auto far = [&](Vec3 c) { return std::abs(dot(p - dome.centre - c, dome.axis)); };
        if (!best || far(centre) < far(*best)) best = centre;
    }
    if (best) *best = *best + dome.centre;
    return best;
}

// A circle that does not turn, when it is as high as `p`: its centre, and how far that goes for 1
// mm along the axis.
struct MovingCircle {
    Vec3 centre, slope;
    double radius = 0.0;
};

std::optional<MovingCircle> circle_at_height(const Form& form, Vec3 axis, Vec3 p) {
    if (const auto* f = std::get_if<Coil>(&form)) {
        if (!is_parallel(f->axis, axis)) return std::nullopt;
        const CoilPlace place = place_at_height(*f, p);
        return MovingCircle{place.centre, axis + (f->reach / f->lead) * place.way, f->radius};
    }
    const auto moved = moved_circle(form, axis);
    if (!moved || !is_parallel(moved->axis, axis)) return std::nullopt;
    const Vec3 slope = (1.0 / dot(moved->along, axis)) * moved->along;
    return MovingCircle{moved->centre + dot(p - moved->centre, axis) * slope, slope, moved->radius};
}

// Where the tool stands ahead of what it left a turn before, the point below its circle is of
// another one, which was behind there.
bool is_of_circle(const Coil& coil, Vec3 centre, Vec3 p) {
    return dot(place_on(coil, p).out, p - centre) > 0.0;
}

// The same of a coil: near the height of `p`.
std::optional<Vec3> common_circle(const Coil& coil, const Form& other, Vec3 p) {
    const Vec3 start = p;
    constexpr double kEqual = 1e-6, kFarthestStep = 0.3;
    constexpr int kMostSteps = 30;
    if (const auto* wall = std::get_if<Cylinder>(&other)) {
        // It stands where the circle passes once in a turn.
        if (!is_parallel(wall->axis, coil.axis)) return std::nullopt;
        const CoilPlace near_p = place_at_height(coil, p);
        const Vec3 up = away(coil.centre, coil.axis, near_p.centre);
        const Vec3 to = away(coil.centre, coil.axis, wall->origin);
        const double degrees = trig::angle_of(dot(to, up), dot(to, cross(coil.axis, up)));
        p = near_p.centre + (degrees * trig::kRadiansPerDegree * coil.lead) * coil.axis;
    }
    Vec3 at = p;
    for (int step = 0; step < kMostSteps; ++step) {
        const auto one = circle_at_height(coil, coil.axis, at);
        const auto two = circle_at_height(other, coil.axis, at);
        if (!two || std::abs(two->radius - coil.radius) > kEqual) return std::nullopt;
        const Vec3 apart = two->centre - one->centre, drift = two->slope - one->slope;
        const double square = dot(drift, drift);
        if (square < kEqual * kEqual) return std::nullopt;
        const double farthest = kFarthestStep * std::abs(coil.lead);
        const double up = std::clamp(-dot(apart, drift) / square, -farthest, farthest);
        at = at + up * coil.axis;
        constexpr double kNoStep = 1e-14;
        if (std::abs(up) > kNoStep && step + 1 < kMostSteps) continue;
        if (norm(apart) > kTouchMm || !is_of_circle(coil, one->centre, start)) return std::nullopt;
        return one->centre;
    }
    return std::nullopt;
}

std::optional<Vec3> common_circle(const Form& a, const Form& b, Vec3 p) {
    if (const auto* coil = std::get_if<Coil>(&b)) return common_circle(*coil, a, p);
    if (const auto* coil = std::get_if<Coil>(&a)) return common_circle(*coil, b, p);
    if (const auto* dome = std::get_if<Dome>(&b)) return common_circle(*dome, a, p);
    if (const auto* dome = std::get_if<Dome>(&a)) return common_circle(*dome, b, p);
    return std::nullopt;
}

// Of a dome and another form, through `p` and `q`.
std::optional<Curve> meet(const Dome& dome, const Form& other, Vec3 p, Vec3 q) {
    if (const auto* plane = std::get_if<Plane>(&other)) {
        const bool is_level = is_parallel(plane->normal, dome.axis);
        if (touch(other, dome)) {
            const Vec3 centre = dome.centre - distance(other, dome.centre) * plane->normal;
            return Circle{centre, plane->normal, is_level ? dome.radius : dome.reach};
        }
        if (!is_level) return std::nullopt;
        return Circle{centre_at_height(dome, plane->origin), dome.axis, dome.radius};
    }
    const auto centre = common_circle(dome, other, p);
    const auto is_level = [&](Vec3 at) { return near(dot(at - *centre, dome.axis), 0.0); };
    if (!centre || !is_level(p) || !is_level(q)) return std::nullopt;
    return Circle{*centre, dome.axis, dome.radius};
}

// The same of a coil. Where the tool stands ahead of what it left a turn before, their curve ends
// on a common circle, but passes lower, where the circle was behind.
std::optional<Curve> meet(const Coil& coil, const Form& other, Vec3 p, Vec3 q, Vec3 near_to) {
    const auto is_level = [&](Vec3 a, Vec3 b) { return near(dot(a - b, coil.axis), 0.0); };
    if (const auto* plane = std::get_if<Plane>(&other)) {
        if (!is_parallel(plane->normal, coil.axis)) return std::nullopt;
        return Circle{place_at_height(coil, plane->origin).centre, coil.axis, coil.radius};
    }
    const auto centre = common_circle(coil, other, p);
    if (!centre || !is_level(p, *centre) || !is_level(q, *centre)) return std::nullopt;
    if (!is_of_circle(coil, *centre, near_to)) return std::nullopt;
    return Circle{*centre, coil.axis, coil.radius};
}

bool is_nearer(const Plane& one, const Plane& other, Vec3 p) {
    return std::abs(distance(one, p)) < std::abs(distance(other, p));
}

// Along `axis`?
bool is_upright(const Form& form, Vec3 axis) {
    if (const auto* plane = std::get_if<Plane>(&form)) return is_across(plane->normal, axis);
    if (const auto* cylinder = std::get_if<Cylinder>(&form))
        return is_parallel(cylinder->axis, axis);
    const auto* spiral = std::get_if<Spiral>(&form);
    return spiral && is_parallel(spiral->axis, axis);
}

// Of a spiral and another form: upright lines, or none that has a name.
std::optional<Curve> meet(const Spiral& spiral, const Form& other) {
    if (is_upright(other, spiral.axis)) return Line{};
    return std::nullopt;
}

bool is_ruled(const Form& form) {
    return std::holds_alternative<Plane>(form) || std::holds_alternative<Cylinder>(form) ||
           std::holds_alternative<Cone>(form) || std::holds_alternative<Extrusion>(form);
}

// Eigenvectors of a symmetric matrix, by rotations (Jacobi).
struct Eigen {
    std::array<double, 3> values;
    std::array<Vec3, 3> vectors;
};

Eigen eigen(std::array<std::array<double, 3>, 3> m) {
    std::array<std::array<double, 3>, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int kSweeps = 12;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        const double off = std::abs(m[0][1]) + std::abs(m[0][2]) + std::abs(m[1][2]);
        if (off <= 1e-18 * trace) break;
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (m[p][q] == 0.0) continue;
            const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            const double t =
                (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
            const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = m[k][p], b = m[k][q];
                m[k][p] = c * a - s * b;
                m[k][q] = s * a + c * b;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = m[p][k], b = m[q][k];
                m[p][k] = c * a - s * b;
                m[q][k] = s * a + c * b;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = v[k][p], b = v[k][q];
                v[k][p] = c * a - s * b;
                v[k][q] = s * a + c * b;
            }
        }
    }
    Eigen result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result.values[i] = m[i][i];
        result.vectors[i] = {v[0][i], v[1][i], v[2][i]};
    }
    return result;
}

// The shortest step that comes nearest to right, where m may say nothing of some directions.
Vec3 shortest_step(const std::array<std::array<double, 3>, 3>& m, Vec3 right) {
    constexpr double kFlat = 1e-9;
    // Where it says enough of all of them, by cofactors.
    constexpr double kClear = 1e-2;
    const Vec3 x{m[0][0], m[0][1], m[0][2]}, y{m[1][0], m[1][1], m[1][2]};
    const Vec3 z{m[2][0], m[2][1], m[2][2]};
    const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = dot(x, yz), mean = (x.x + y.y + z.z) / 3.0;
    if (determinant > kClear * mean * mean * mean)
        return (1.0 / determinant) * (right.x * yz + right.y * zx + right.z * xy);
    const Eigen e = eigen(m);
    const double largest = std::max({e.values[0], e.values[1], e.values[2]});
    Vec3 step;
    for (std::size_t i = 0; i < 3; ++i) {
        if (e.values[i] > kFlat * largest)
            step = step + (dot(right, e.vectors[i]) / e.values[i]) * e.vectors[i];
    }
    return step;
}

}  // namespace

std::optional<Form> touch(const Form& a, const Form& b) {
    return a.index() <= b.index() ? std::visit(Touch{}, a, b) : std::visit(Touch{}, b, a);
}

std::optional<Form> mitre_of(const Form& a, const Form& b, Vec3 p) {
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
    const auto planes = first && second ? mitres(*first, *second) : bends(a, b);
    if (!planes) return std::nullopt;
    const auto& [one, other] = *planes;
    return is_nearer(one, other, p) ? one : other;
}

std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p) {
    const auto planes = bends(a, b);
    if (!planes) return std::nullopt;
    const auto& [level, other] = *planes;
    const auto* moved = std::get_if<Extrusion>(&a);
    if (!moved) moved = std::get_if<Extrusion>(&b);
    const Vec3 side = moved->radius * normalized(cross(level.normal, other.normal));
    const Vec3 one = level.origin + side, two = level.origin - side;
    return norm(p - one) < norm(p - two) ? one : two;
}

std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p, Vec3 q) {
    const auto planes = bends(a, b);
    if (!planes) return std::nullopt;
    const auto& [level, other] = *planes;
    const auto is_on = [](const Plane& plane, Vec3 at) {
        return std::abs(distance(plane, at)) < kTouchMm;
    };
    if (is_on(level, p) == is_on(level, q) || is_on(other, p) == is_on(other, q) ||
        is_on(level, p) == is_on(other, p))
        return std::nullopt;
    return corner_of_bend(a, b, is_on(level, p) ? p : q);
}

std::optional<Form> ellipse_of_bend(const Form& a, const Form& b, Vec3 p) {
    const auto planes = bends(a, b);
    if (!planes) return std::nullopt;
    const auto& [level, other] = *planes;
    if (std::abs(distance(level, p)) > kTouchMm || std::abs(distance(other, p)) < kTouchMm)
        return std::nullopt;
    return other;
}

std::optional<Form> corner_of_dome(std::span<const Form* const> forms) {
    for (const Form* form : forms) {
        const auto* dome = std::get_if<Dome>(form);
        if (!dome) continue;
        bool has_floor = false, has_wall = false;
        for (const Form* other : forms) {
            const auto* plane = std::get_if<Plane>(other);
            if (!plane || !touch(*plane, *dome)) continue;
            (is_parallel(plane->normal, dome->axis) ? has_floor : has_wall) = true;
        }
        if (has_floor && has_wall) return Plane{dome->centre, dome->ahead};
    }
    return std::nullopt;
}

std::vector<Form> touches_in_level(std::span<const Form* const> forms) {
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
        for (const Form* other : forms) {
            if (const auto* f = std::get_if<Dome>(other)) {
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
                const Vec3 apart = away(a.centre, level->normal, b.centre);
                const double d = norm(apart);
                if ((!a.moves && !b.moves) || d < kApart) continue;
                if (near(d, a.radius + b.radius) || near(d, std::abs(a.radius - b.radius)))
                    planes.push_back(Plane{a.centre, normalized(cross(level->normal, apart))});
            }
        }
    }
    return planes;
}

std::optional<Curve> meet(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 near_to) {
    if (const auto axis = common_axis(a, b)) return circle_about(axis->origin, axis->direction, p);
    if (const auto* coil = std::get_if<Coil>(&a)) return meet(*coil, b, p, q, near_to);
    if (const auto* coil = std::get_if<Coil>(&b)) return meet(*coil, a, p, q, near_to);
    if (const auto* spiral = std::get_if<Spiral>(&a)) return meet(*spiral, b);
    if (const auto* spiral = std::get_if<Spiral>(&b)) return meet(*spiral, a);
    if (const auto* dome = std::get_if<Dome>(&a)) return meet(*dome, b, p, q);
    if (const auto* dome = std::get_if<Dome>(&b)) return meet(*dome, a, p, q);
    const bool is_first_plane = std::holds_alternative<Plane>(a);
    const bool is_second_plane = std::holds_alternative<Plane>(b);
    if (is_first_plane && is_second_plane) return Line{};
    if (const auto touching = touch(a, b)) {
        if (is_ruled(a) && is_ruled(b)) return Line{};
        for (const Form* form : {&a, &b}) {
            if (const auto* pipe = std::get_if<Cylinder>(form))
                return circle_about(pipe->origin, pipe->axis, p);
        }
        for (const Form* form : {&a, &b}) {
            const auto* plane = std::get_if<Plane>(&*touching);
            if (const auto* ring = std::get_if<Torus>(form); ring && plane)
                return meridian(*ring, plane->normal, p);
        }
        return std::nullopt;
    }
    const auto* first = std::get_if<Cylinder>(&a);
    const auto* second = std::get_if<Cylinder>(&b);
    if (first && second) {
        if (is_parallel(first->axis, second->axis)) return Line{};
        const auto planes = mitres(*first, *second);
        if (!planes) return std::nullopt;
        const auto is_on = [&](const Plane& plane) {
            return std::abs(distance(plane, p)) < kTouchMm &&
                   std::abs(distance(plane, q)) < kTouchMm;
        };
        const auto& [one, other] = *planes;
        if (!is_on(one) && !is_on(other)) return std::nullopt;
        // Both ellipses pass through the points where the pipes touch.
        const bool is_first = is_on(one) && (!is_on(other) || is_nearer(one, other, near_to));
        return ellipse(is_first ? one : other, *first);
    }
    if (const auto planes = bends(a, b)) {
        const auto is_on = [&](const Plane& plane) {
            return std::abs(distance(plane, p)) < kTouchMm &&
                   std::abs(distance(plane, q)) < kTouchMm;
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
        if (std::abs(dot(plane.normal, f->axis)) <= kParallel) return Line{};
        return ellipse(plane, *f);
    }
    if (const auto* f = std::get_if<Extrusion>(&other)) {
        if (is_across(plane.normal, f->along)) return Line{};
        if (is_parallel(plane.normal, f->axis)) {
            const double height = dot(plane.normal, plane.origin - f->centre);
            const Vec3 centre = f->centre + (height / dot(plane.normal, f->along)) * f->along;
            return Circle{centre, f->axis, f->radius};
        }
        return ellipse(plane, *f);
    }
    if (const auto* f = std::get_if<Torus>(&other)) {
        if (is_across(plane.normal, f->axis) && std::abs(distance(plane, f->centre)) < 1e-7)
            return meridian(*f, plane.normal, p);
    }
    if (std::holds_alternative<Cone>(other)) {
        // Rulings pass through the apex.
        constexpr double kOn = 1e-9;
        const Vec3 middle = 0.5 * (p + q);
        if (norm(q - p) > kTouchMm && std::abs(distance(plane, std::get<Cone>(other).apex)) < kOn &&
            std::abs(distance(other, middle)) < kOn)
            return Line{};
    }
    return std::nullopt;
}

double solve(std::span<const Form* const> forms, Vec3& p) {
    constexpr int kMostSteps = 60;
    constexpr double kLongest = 1.0;
    // Steps this short are rounding, as soon as they do not become shorter.
    constexpr double kRounding = 1e-10;
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step) {
        std::array<std::array<double, 3>, 3> m{};
        Vec3 right;
        for (const Form* form : forms) {
            const Vec3 g = gradient(*form, p);
            const double d = distance(*form, p);
            right = right - d * g;
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j)
                    m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += g[i] * g[j];
            }
        }
        const Vec3 move = shortest_step(m, right);
        const double length = norm(move);
        p = p + (length > kLongest ? kLongest / length : 1.0) * move;
        if (length == 0.0 || (length < kRounding && length > 0.5 * before)) break;
        before = length;
    }
    double miss = 0.0;
    for (const Form* form : forms)
        miss = std::max(miss, std::abs(distance(*form, p)));
    return miss;
}

}  // namespace ncsim::brep
