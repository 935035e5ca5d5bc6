// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lookup of equal surfaces by a scalar key.
#include "sources/surface_set.h"

#include "geometry/tolerances.h"

#include <cmath>

namespace ncsim::brep {

namespace {

// Direction without symmetry.
constexpr Vec3 kAskew{0.4837, 0.6291, 0.6087};

double along(Vec3 axis) {
    return std::abs(dot(axis, kAskew));
}

// Returns a number for the position of an axis, from the axis point nearest to the origin.
double place(Vec3 origin, Vec3 axis) {
    return dot(origin - dot(origin, axis) * axis, kAskew);
}

struct Key {
    double operator()(const Plane& f) const {
        return dot(f.origin, f.normal) + dot(f.normal, kAskew);
    }
    double operator()(const Cylinder& f) const {
        return place(f.origin, f.axis) + 0.7 * f.radius + along(f.axis);
    }
    double operator()(const Cone& f) const { return dot(f.apex, kAskew) + dot(f.axis, kAskew); }
    double operator()(const Sphere& f) const { return dot(f.centre, kAskew) + 0.7 * f.radius; }
    double operator()(const Torus& f) const {
        return dot(f.centre, kAskew) + 0.7 * f.major + 0.3 * f.minor + along(f.axis);
    }
    double operator()(const Extrusion& f) const {
        return place(f.centre, f.along) + 0.7 * f.radius + along(f.along) + 0.5 * along(f.axis);
    }
    double operator()(const Dome& f) const {
        return dot(f.centre, kAskew) + 0.7 * f.radius + 0.3 * f.reach + along(f.axis) +
               dot(f.ahead, kAskew);
    }
    double operator()(const Coil& f) const {
        return place(f.centre, f.axis) + 0.7 * f.radius + 0.3 * f.reach + along(f.axis) + f.lead;
    }
    double operator()(const Spiral& f) const {
        return place(f.centre, f.axis) + 0.7 * f.reach + 0.3 * f.offset + along(f.axis) + f.lead;
    }
    // Independent of the piece of a line, and of the direction of all other paths.
    double operator()(const Envelope& f) const {
        const Sweep& sweep = *f.sweep;
        const PathFrame first = path_frame(sweep, sweep.at(0.0)),
                        last = path_frame(sweep, sweep.at(1.0));
        const Fillet* fillet = sweep.fillet();
        const double own = fillet ? 0.7 * fillet->radius + 0.3 * fillet->centre_radius : 0.0;
        if (std::holds_alternative<StraightPath>(sweep.path()))
            return place(first.centre, first.ahead) + own + along(first.ahead);
        return own + 0.5 * dot(first.centre + last.centre, kAskew);
    }
    double operator()(const Helicoid& f) const { return place(f.centre, f.axis) + f.lead; }
    double operator()(const Characteristic& f) const { return (*this)(f.of) + f.t; }
    double operator()(const Trail& f) const { return (*this)(f.of) + f.rise; }
};

}  // namespace

std::uint32_t SurfaceSet::add(const Surface& surface) {
    const double key = std::visit(Key{}, surface.form);
    // A key is a sum of a few lengths that differ by up to 20 times the error of points if the
    // surfaces are equal, times factors of at most 1, for parts of up to a metre.
    const double range = 400.0 * kPointError;
    const auto end = by_key_.upper_bound(key + range);
    for (auto at = by_key_.lower_bound(key - range); at != end; ++at) {
        if (is_same(surfaces_[at->second], surface, 20.0 * kPointError)) return at->second;
    }
    const std::uint32_t number = add_alone(surface);
    by_key_.emplace(key, number);
    return number;
}

std::uint32_t SurfaceSet::add_alone(const Surface& surface) {
    surfaces_.push_back(surface);
    return static_cast<std::uint32_t>(surfaces_.size() - 1);
}

}  // namespace ncsim::brep
