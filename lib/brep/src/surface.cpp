// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/surface.h"

#include "ncsim/trig/angles.h"

#include <cmath>
#include <numbers>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

// A point seen from an axis.
struct Polar {
    double height, radius;
    Vec3 away;  // unit, from the axis; zero on it
};

Polar polar(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    const double height = dot(v, axis);
    const Vec3 out = v - height * axis;
    const double radius = norm(out);
    return {height, radius, radius > 0.0 ? (1.0 / radius) * out : Vec3{}};
}

// Cosine and sine of half the angle at the apex.
struct Opening {
    explicit Opening(double slope) : cos{1.0 / std::sqrt(1.0 + slope * slope)}, sin{slope * cos} {}
    double cos, sin;
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
};

struct Gradient {
    Vec3 p;
    Vec3 operator()(const Plane& f) const { return f.normal; }
    Vec3 operator()(const Cylinder& f) const { return polar(f.origin, f.axis, p).away; }
    Vec3 operator()(const Cone& f) const {
        const Polar at = polar(f.apex, f.axis, p);
        const Opening half(f.slope);
        return at.radius > 0.0 ? half.cos * at.away - half.sin * f.axis : Vec3{};
    }
    Vec3 operator()(const Sphere& f) const { return normalized(p - f.centre); }
    Vec3 operator()(const Torus& f) const {
        const Polar at = polar(f.centre, f.axis, p);
        return normalized((at.radius - f.major) * at.away + at.height * f.axis);
    }
};

bool is_parallel(Vec3 a, Vec3 b, double tolerance) {
    return norm(cross(a, b)) <= tolerance;
}

// Angles count over this length, mm: that of a part.
constexpr double kReach = 100.0;

struct Same {
    double tolerance;
    bool near(double a, double b) const { return std::abs(a - b) <= tolerance; }
    bool near(Vec3 a, Vec3 b) const { return norm(a - b) <= tolerance; }
    bool turned(Vec3 a, Vec3 b) const { return !is_parallel(a, b, tolerance / kReach); }
    bool operator()(const Plane& a, const Plane& b) const {
        return !turned(a.normal, b.normal) && dot(a.normal, b.normal) > 0.0 &&
               std::abs(Distance{b.origin}(a)) <= tolerance &&
               std::abs(Distance{a.origin}(b)) <= tolerance;
    }
    bool operator()(const Cylinder& a, const Cylinder& b) const {
        return near(a.radius, b.radius) && !turned(a.axis, b.axis) &&
               polar(a.origin, a.axis, b.origin).radius <= tolerance;
    }
    bool operator()(const Cone& a, const Cone& b) const {
        return near(a.apex, b.apex) && !turned(a.axis, b.axis) && dot(a.axis, b.axis) > 0.0 &&
               std::abs(a.slope - b.slope) <= tolerance / kReach;
    }
    bool operator()(const Sphere& a, const Sphere& b) const {
        return near(a.centre, b.centre) && near(a.radius, b.radius);
    }
    bool operator()(const Torus& a, const Torus& b) const {
        return near(a.centre, b.centre) && near(a.major, b.major) && near(a.minor, b.minor) &&
               !turned(a.axis, b.axis);
    }
    template <typename A, typename B>
    bool operator()(const A&, const B&) const {
        return false;
    }
};

}  // namespace

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
    return 0.0;
}

double half_angle_rad(const Cone& cone) {
    return trig::angle_of(1.0, cone.slope) * (std::numbers::pi / 180.0);
}

Vec3 across(Vec3 axis) {
    constexpr double kSteep = 0.9;
    const Vec3 x{1, 0, 0}, y{0, 1, 0};
    const Vec3 start = std::abs(axis.x) < kSteep ? x : y;
    return normalized(start - dot(start, axis) * axis);
}

}  // namespace ncsim::brep
