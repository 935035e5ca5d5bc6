// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces that a round tool leaves on a part: what CAD knows as such. mm, frame W.
#pragma once

#include "ncsim/cda/vec.h"

#include <array>
#include <string_view>
#include <variant>

namespace ncsim::brep {

using cda::Vec3;

struct Plane {
    Vec3 origin, normal;  ///< Any point of it; unit.
    bool operator==(const Plane&) const = default;
};
struct Cylinder {
    Vec3 origin, axis;  ///< Any point of the axis; unit.
    double radius = 0.0;
    bool operator==(const Cylinder&) const = default;
};
/// One nappe: the side of the apex to which the axis points.
struct Cone {
    Vec3 apex, axis;
    double slope = 0.0;  ///< Radius per height above the apex, > 0.
    bool operator==(const Cone&) const = default;
};
struct Sphere {
    Vec3 centre;
    double radius = 0.0;
    bool operator==(const Sphere&) const = default;
};
/// A ring: major > minor.
struct Torus {
    Vec3 centre, axis;
    double major = 0.0, minor = 0.0;
    bool operator==(const Torus&) const = default;
};

/// What a circle passes that moves along a line askew to its plane: an elliptic cylinder.
struct Extrusion {
    Vec3 centre, axis;  ///< Of the circle in any of its places; unit, at right angles to its plane.
    Vec3 along;         ///< Of the line: unit; to the side to which the axis points.
    double radius = 0.0;
    bool operator==(const Extrusion&) const = default;
};

using Form = std::variant<Plane, Cylinder, Cone, Sphere, Torus, Extrusion>;

/// A form, and on which side of it the material is.
struct Surface {
    Form form;
    /// Material is where distance() > 0: what a tool leaves outside of itself. Never for planes.
    bool is_hollow = false;
    bool operator==(const Surface&) const = default;
};

/// From the form, signed: positive outside (before the plane). Of cones that of the nappe continued
/// beyond the apex.
double distance(const Form& form, Vec3 p);
/// Unit gradient of distance(); zero where there is none (on an axis, in a centre).
Vec3 gradient(const Form& form, Vec3 p);
/// Unit, out of the material.
Vec3 outward(const Surface& surface, Vec3 p);

/// The same surface, as far as lengths of `tolerance_mm` tell; with the material on the same side.
bool is_same(const Surface& a, const Surface& b, double tolerance_mm);

/// What forms are called, by their index.
inline constexpr std::array<std::string_view, 6> kForms{"plane",  "cylinder", "cone",
                                                        "sphere", "torus",    "extrusion"};
/// The largest radius of curvature; 0 for planes, and for cones, which have any.
double radius_of(const Form& form);

/// Where along its line the circle of an extrusion passes `p`: how far from `centre`.
double place_along(const Extrusion& extrusion, Vec3 p);

/// Between the axis and the side.
double half_angle_rad(const Cone& cone);

/// A direction at right angles to `axis` (unit), the same for all that are nearly equal: that of X
/// as far as it goes, for Z-axes X itself.
Vec3 across(Vec3 axis);

}  // namespace ncsim::brep
