// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances, gradients and places on all forms.
#include "ncsim/brep/surface_forms.h"

#include "ncsim/base/angles.h"

#include "geometry/ellipse.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::brep {

namespace {

// Point in cylindrical coordinates about an axis.
struct Polar {
    double height, radius;
    Vec3 radial;  // Unit, from the axis; zero on the axis.
};

Polar polar(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    const double height = dot(v, axis);
    const Vec3 out = v - height * axis;
    const double radius = norm(out);
    return {height, radius, radius > 0.0 ? (1.0 / radius) * out : Vec3{}};
}

// Cosine and sine of half the opening angle.
struct Opening {
    explicit Opening(double slope) : cos{1.0 / std::sqrt(1.0 + slope * slope)}, sin{slope * cos} {}
    double cos, sin;
};

// Elliptic cylinder, projected along its rulings.
struct AlongRulings {
    explicit AlongRulings(const Extrusion& f)
        : x(normalized(cross(f.axis, f.along))),
          y(cross(f.along, x)),
          a(f.radius),
          b(f.radius * dot(f.axis, f.along)) {}
    Vec3 x, y;
    double a, b;
    EllipseFoot foot(const Extrusion& f, Vec3 p) const {
        const Vec3 v = p - f.centre;
        return foot_on_ellipse(a, b, dot(v, x), dot(v, y));
    }
};

// Returns the unit normal, out of the circle; zero where the path is level and tangent to the
// circle.
Vec3 normal_at(const Dome& f, const DomePlace& place) {
    return normalized(place.cosine * place.out - dot(place.out, place.along) * f.axis);
}

Vec3 normal_at(const Coil& f, const CoilPlace& place) {
    const double sign = f.lead > 0.0 ? 1.0 : -1.0;
    return normalized(sign *
                      (f.lead * place.out - f.reach * dot(place.out, place.motion) * f.axis));
}

// Distance from the line across the axis at the height of `p`, and the gradient of this distance.
struct BesideHelix {
    BesideHelix(const Helicoid& f, Vec3 p) {
        const Vec3 v = p - f.centre;
        const auto t = sin_cos(dot(v, f.axis) / f.lead / kRadiansPerDegree);
        const Vec3 side = cross(f.axis, f.ahead);
        const Vec3 up = t.cos * f.ahead + t.sin * side, tangent = t.cos * side - t.sin * f.ahead;
        deviation = dot(v, tangent);
        slope = tangent - (dot(v, up) / f.lead) * f.axis;
    }
    double deviation = 0.0;
    Vec3 slope;
};

struct Distance {
    Vec3 p;
    double operator()(const Plane& f) const { return dot(f.normal, p - f.origin); }
    double operator()(const Cylinder& f) const {
        return polar(f.origin, f.axis, p).radius - f.radius;
    }
    double operator()(const Cone& f) const {
        const Polar at = polar(f.apex, f.axis, p);
        const Opening half(f.slope);
        return at.radius * half.cos - at.height * half.sin;
    }
    double operator()(const Sphere& f) const { return norm(p - f.centre) - f.radius; }
    double operator()(const Torus& f) const {
        const Polar at = polar(f.centre, f.axis, p);
        const double out = at.radius - f.major;
        return std::sqrt(out * out + at.height * at.height) - f.minor;
    }
    double operator()(const Extrusion& f) const { return AlongRulings(f).foot(f, p).distance; }
    double operator()(const Dome& f) const {
        const DomePlace place = project_onto(f, p);
        const Vec3 deviation = p - point_at(f, place);
        return dot(deviation, normal_at(f, place)) < 0.0 ? -norm(deviation) : norm(deviation);
    }
    double operator()(const Coil& f) const {
        const CoilPlace place = project_onto(f, p);
        const Vec3 deviation = p - place.centre - f.radius * place.out;
        return dot(deviation, normal_at(f, place)) < 0.0 ? -norm(deviation) : norm(deviation);
    }
    double operator()(const Spiral& f) const {
        const SpiralPlace place = project_onto(f, p);
        return dot(p - place.path_point, place.out) - f.offset;
    }
    double operator()(const Helicoid& f) const {
        const BesideHelix at(f, p);
        return at.deviation / norm(at.slope);
    }
    double operator()(const Envelope& f) const { return project_onto(f, p).deviation; }
    double operator()(const Characteristic& f) const {
        const ClosestPoint closest = closest_point_at(*f.of.sweep, f.t, p);
        const double slope = norm(closest.drift);
        return slope > 0.0 ? closest.rate / slope : 0.0;
    }
    double operator()(const Trail& f) const {
        const ClosestPoint closest = project_onto(f.of, p);
        const double slope = norm(gradient_of_rise(*f.of.sweep, closest));
        return slope > 0.0 ? (dot(closest.normal, closest.tool.axis) - f.rise) / slope : 0.0;
    }
};

struct Gradient {
    Vec3 p;
    Vec3 operator()(const Plane& f) const { return f.normal; }
    Vec3 operator()(const Cylinder& f) const { return polar(f.origin, f.axis, p).radial; }
    Vec3 operator()(const Cone& f) const {
        const Polar at = polar(f.apex, f.axis, p);
        const Opening half(f.slope);
        return at.radius > 0.0 ? half.cos * at.radial - half.sin * f.axis : Vec3{};
    }
    Vec3 operator()(const Sphere& f) const { return normalized(p - f.centre); }
    Vec3 operator()(const Torus& f) const {
        const Polar at = polar(f.centre, f.axis, p);
        return normalized((at.radius - f.major) * at.radial + at.height * f.axis);
    }
    Vec3 operator()(const Extrusion& f) const {
        const AlongRulings seen(f);
        const EllipseFoot foot = seen.foot(f, p);
        return foot.x * seen.x + foot.y * seen.y;
    }
    Vec3 operator()(const Dome& f) const { return normal_at(f, project_onto(f, p)); }
    Vec3 operator()(const Coil& f) const { return normal_at(f, project_onto(f, p)); }
    Vec3 operator()(const Spiral& f) const { return project_onto(f, p).out; }
    Vec3 operator()(const Helicoid& f) const { return normalized(BesideHelix(f, p).slope); }
    Vec3 operator()(const Envelope& f) const { return project_onto(f, p).normal; }
    Vec3 operator()(const Characteristic& f) const {
        return normalized(closest_point_at(*f.of.sweep, f.t, p).drift);
    }
    Vec3 operator()(const Trail& f) const {
        return normalized(gradient_of_rise(*f.of.sweep, project_onto(f.of, p)));
    }
};

struct Both {
    Vec3 p;
    DistanceAndGradient operator()(const Extrusion& f) const {
        const AlongRulings seen(f);
        const EllipseFoot foot = seen.foot(f, p);
        return {foot.distance, foot.x * seen.x + foot.y * seen.y};
    }
    DistanceAndGradient operator()(const Dome& f) const {
        const DomePlace place = project_onto(f, p);
        return with_sign(p - point_at(f, place), normal_at(f, place));
    }
    DistanceAndGradient operator()(const Coil& f) const {
        const CoilPlace place = project_onto(f, p);
        return with_sign(p - place.centre - f.radius * place.out, normal_at(f, place));
    }
    DistanceAndGradient operator()(const Spiral& f) const {
        const SpiralPlace place = project_onto(f, p);
        return {dot(p - place.path_point, place.out) - f.offset, place.out};
    }
    DistanceAndGradient operator()(const Envelope& f) const {
        const ClosestPoint closest = project_onto(f, p);
        return {closest.deviation, closest.normal};
    }
    template <typename F>
    DistanceAndGradient operator()(const F& f) const {
        return {Distance{p}(f), Gradient{p}(f)};
    }

private:
    static DistanceAndGradient with_sign(Vec3 v, Vec3 normal) {
        return {dot(v, normal) < 0.0 ? -norm(v) : norm(v), normal};
    }
};

bool is_parallel(Vec3 a, Vec3 b, double tolerance) {
    return norm(cross(a, b)) <= tolerance;
}

struct Same {
    double tolerance;
    bool is_near(double a, double b) const { return std::abs(a - b) <= tolerance; }
    bool is_near(Vec3 a, Vec3 b) const { return norm(a - b) <= tolerance; }
    bool differ_in_direction(Vec3 a, Vec3 b) const {
        return !is_parallel(a, b, tolerance / kPartMm);
    }
    bool operator()(const Plane& a, const Plane& b) const {
        return !differ_in_direction(a.normal, b.normal) && dot(a.normal, b.normal) > 0.0 &&
               std::abs(Distance{b.origin}(a)) <= tolerance &&
               std::abs(Distance{a.origin}(b)) <= tolerance;
    }
    bool operator()(const Cylinder& a, const Cylinder& b) const {
        return is_near(a.radius, b.radius) && !differ_in_direction(a.axis, b.axis) &&
               polar(a.origin, a.axis, b.origin).radius <= tolerance;
    }
    bool operator()(const Cone& a, const Cone& b) const {
        return is_near(a.apex, b.apex) && !differ_in_direction(a.axis, b.axis) &&
               dot(a.axis, b.axis) > 0.0 && std::abs(a.slope - b.slope) <= tolerance / kPartMm;
    }
    bool operator()(const Sphere& a, const Sphere& b) const {
        return is_near(a.centre, b.centre) && is_near(a.radius, b.radius);
    }
    bool operator()(const Torus& a, const Torus& b) const {
        return is_near(a.centre, b.centre) && is_near(a.major, b.major) &&
               is_near(a.minor, b.minor) && !differ_in_direction(a.axis, b.axis);
    }
    bool operator()(const Extrusion& a, const Extrusion& b) const {
        return is_near(a.radius, b.radius) && !differ_in_direction(a.axis, b.axis) &&
               !differ_in_direction(a.along, b.along) &&
               polar(a.centre, a.along, b.centre).radius <= tolerance;
    }
    bool operator()(const Dome& a, const Dome& b) const {
        return is_near(a.radius, b.radius) && is_near(a.reach, b.reach) &&
               is_near(a.centre, b.centre) && !differ_in_direction(a.axis, b.axis) &&
               !differ_in_direction(a.ahead, b.ahead) && dot(a.axis, b.axis) > 0.0 &&
               dot(a.ahead, b.ahead) > 0.0;
    }
    // Independent of the angle from which each coil starts.
    bool operator()(const Coil& a, const Coil& b) const {
        const Vec3 start = b.centre + b.reach * b.ahead;
        return is_near(a.radius, b.radius) && is_near(a.reach, b.reach) &&
               !differ_in_direction(a.axis, b.axis) && dot(a.axis, b.axis) > 0.0 &&
               polar(a.centre, a.axis, b.centre).radius <= tolerance &&
               std::abs(a.lead - b.lead) <= tolerance / kPartMm &&
               is_near(place_at_height(a, start).centre, start);
    }
    bool operator()(const Spiral& a, const Spiral& b) const {
        return is_near(a.reach, b.reach) && is_near(a.offset, b.offset) &&
               !differ_in_direction(a.axis, b.axis) && !differ_in_direction(a.ahead, b.ahead) &&
               dot(a.axis, b.axis) > 0.0 && dot(a.ahead, b.ahead) > 0.0 &&
               std::abs(a.lead - b.lead) <= tolerance / kPartMm &&
               polar(a.centre, a.axis, b.centre).radius <= tolerance;
    }
    bool operator()(const Envelope& a, const Envelope& b) const {
        return brep::is_same(a, b, tolerance);
    }
    template <typename A, typename B>
    bool operator()(const A&, const B&) const {
        return false;
    }
};

}  // namespace

DistanceAndGradient evaluate(const Form& form, Vec3 p) {
    return std::visit(Both{p}, form);
}

DistanceAndGradient evaluate(const Form& form, Vec3 p, ProjectionSeed& seed) {
    const auto* envelope = std::get_if<Envelope>(&form);
    if (!envelope) return evaluate(form, p);
    const ClosestPoint closest = project_onto(*envelope, p, seed);
    return {closest.deviation, closest.normal};
}

double distance(const Form& form, Vec3 p, ProjectionSeed& seed) {
    const auto* envelope = std::get_if<Envelope>(&form);
    return envelope ? project_onto(*envelope, p, seed).deviation : distance(form, p);
}

double distance(const Form& form, Vec3 p) {
    return std::visit(Distance{p}, form);
}

Vec3 gradient(const Form& form, Vec3 p) {
    return std::visit(Gradient{p}, form);
}

Vec3 outward(const Surface& surface, Vec3 p) {
    const Vec3 n = gradient(surface.form, p);
    return surface.is_hollow ? -n : n;
}

bool is_same(const Surface& a, const Surface& b, double tolerance_mm) {
    return a.is_hollow == b.is_hollow && std::visit(Same{tolerance_mm}, a.form, b.form);
}

double radius_of(const Form& form) {
    if (const auto* f = std::get_if<Cylinder>(&form)) return f->radius;
    if (const auto* f = std::get_if<Sphere>(&form)) return f->radius;
    if (const auto* f = std::get_if<Torus>(&form)) return f->major + f->minor;
    if (const auto* f = std::get_if<Extrusion>(&form)) return f->radius / dot(f->axis, f->along);
    if (const auto* f = std::get_if<Dome>(&form)) return f->reach + f->radius;
    if (const auto* f = std::get_if<Coil>(&form)) return f->reach + f->radius;
    if (const auto* f = std::get_if<Spiral>(&form)) return f->reach + f->offset;
    if (const auto* f = std::get_if<Envelope>(&form)) return largest_radius(*f->sweep);
    return 0.0;
}

double DomePlace::degrees() const {
    return angle_of(cosine, sine);
}

DomePlace project_onto(const Dome& dome, Vec3 p) {
    const Vec3 v = p - dome.centre;
    const auto turn = [&](DomePlace& place, double cosine, double sine) {
        place.cosine = cosine;
        place.sine = sine;
        place.up = cosine * dome.ahead + sine * dome.axis;
        place.along = cosine * dome.axis - sine * dome.ahead;
    };
    DomePlace place;
    const double height = std::clamp(dot(v, dome.axis) / dome.reach, -1.0, 1.0);
    turn(place, std::sqrt(1.0 - height * height), height);
    const auto level = [&](Vec3 w) { return w - dot(w, dome.axis) * dome.axis; };
    place.out = normalized(level(v - dome.reach * place.up));
    if (place.out == Vec3{}) place.out = dome.ahead;
    // Newton's method for both angles at once minimises the distance. Where the second derivatives
    // are not positive definite, the step is the one for `p` on the surface.
    for (int step = 0; step < 40; ++step) {
        const Vec3 deviation = v - dome.reach * place.up - dome.radius * place.out;
        const Vec3 tangent = cross(dome.axis, place.out);
        const double k = dot(tangent, place.along);
        const double a = dot(tangent, deviation), b = dot(place.along, deviation);
        double aa = 1.0 + dot(deviation, place.out) / dome.radius;
        double bb = 1.0 + dot(deviation, place.up) / dome.reach;
        const bool is_least = aa > 0.0 && aa * bb - k * k > 100.0 * kRounding;
        if (!is_least) aa = bb = 1.0;
        const double det = aa * bb - k * k;
        double first = a, second = 0.0;
        if (det > 100.0 * kRounding) {
            first = (a * bb - k * b) / det;
            second = (b * aa - k * a) / det;
        }
        first = std::clamp(first / dome.radius, -0.3, 0.3);
        second = std::clamp(second / dome.reach, -0.3, 0.3);
        place.out = normalized(place.out + first * tangent);
        const double c = place.cosine - second * place.sine, s = place.sine + second * place.cosine;
        const double length = std::sqrt(c * c + s * s);
        turn(place, c / length, s / length);
        // After a step of Newton's method, the error is of the order of the step's square.
        if (std::abs(first) + std::abs(second) <
            (is_least ? 10.0 * kRounding : 0.001 * kUnitRounding))
            break;
    }
    return place;
}

Vec3 point_at(const Dome& dome, const DomePlace& place) {
    return dome.centre + dome.reach * place.up + dome.radius * place.out;
}

Vec3 centre_at_height(const Dome& dome, Vec3 p) {
    const double sine = std::clamp(dot(p - dome.centre, dome.axis) / dome.reach, -1.0, 1.0);
    return dome.centre +
           dome.reach * (std::sqrt(1.0 - sine * sine) * dome.ahead + sine * dome.axis);
}

double place_along(const Extrusion& extrusion, Vec3 p) {
    return dot(p - extrusion.centre, extrusion.axis) / dot(extrusion.along, extrusion.axis);
}

bool is_spindle(const Torus& torus) {
    return torus.major <= torus.minor * (1.0 + kPointError);
}

double tip_degrees(const Torus& spindle) {
    const double major = spindle.major, minor = spindle.minor;
    if (major >= minor) return -kHalfTurnDegrees;
    return angle_of(-major, -std::sqrt(minor * minor - major * major));
}

double half_angle_rad(const Cone& cone) {
    return angle_of(1.0, cone.slope) * (std::numbers::pi / 180.0);
}

Vec3 any_perpendicular(Vec3 axis) {
    const Vec3 x{1, 0, 0}, y{0, 1, 0};
    const Vec3 start = std::abs(axis.x) < 0.9 ? x : y;
    return normalized(start - dot(start, axis) * axis);
}

}  // namespace ncsim::brep
