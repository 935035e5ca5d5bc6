// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces that a round tool leaves on a part: what CAD knows as such. mm, frame W.
#pragma once

#include "ncsim/brep/envelope.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <string_view>
#include <variant>

namespace ncsim::brep {

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

/// What a circle passes that moves along an arc upright to it and does not turn: half of a Bohemian
/// dome. The centre of the circle is at centre + reach (cos t ahead + sin t axis), t from -90 to 90
/// degrees.
struct Dome {
    Vec3 centre, axis;  ///< Of the arc; unit, at right angles to the plane of the circle.
    Vec3 ahead;         ///< Unit, at right angles to the axis: to the side on which the half is.
    double reach = 0.0, radius = 0.0;
    bool operator==(const Dome&) const = default;
};

/// What a circle passes that moves along a helix about an axis upright to it, and does not turn.
/// The centre of the circle is at centre + reach (cos t ahead + sin t side) + lead t axis, t in
/// radians, side = axis x ahead.
struct Coil {
    Vec3 centre, axis;  ///< Of the helix where t is 0; unit.
    Vec3 ahead;         ///< Unit, at right angles to the axis.
    double reach = 0.0, radius = 0.0;
    double lead = 0.0;  ///< mm for each radian, not 0.
    bool operator==(const Coil&) const = default;
};

/// The wall beside a way whose distance from an axis changes evenly with the angle about it, as
/// arcs go whose ends differ in radius: upright, at `offset` from the way, outwards if that is
/// positive. The way is at centre + (reach + lead t) (cos t ahead + sin t side), t in radians from
/// -pi to pi, side = axis x ahead.
struct Spiral {
    Vec3 centre, axis;  ///< Any point of the axis; unit.
    Vec3 ahead;         ///< Unit, at right angles to the axis: to the middle of the way.
    double reach = 0.0, lead = 0.0;  ///< mm; mm for each radian.
    double offset = 0.0;
    bool operator==(const Spiral&) const = default;
};

/// All lines across the axis that meet a helix about it. Faces do not lie on it: it crosses a coil
/// and the walls beside it where they touch.
struct Helicoid {
    Vec3 centre, axis, ahead;
    double lead = 0.0;  ///< As of coils.
    bool operator==(const Helicoid&) const = default;
};

using Form = std::variant<Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Dome, Coil, Spiral,
                          Envelope, Helicoid, Characteristic, Trail>;

/// Is it thicker than it is wide? Of such a ring faces lie below its centre, as seen along its
/// axis, on the side away from the axis, and may have a corner in the tip to which it comes there.
bool is_spindle(const Torus& torus);

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
/// Both at once: on what moves a point is looked for, which costs the most.
struct Off {
    double distance = 0.0;
    Vec3 gradient;
};
Off off(const Form& form, Vec3 p);

/// Of points one after the other.
Off off(const Form& form, Vec3 p, Beside& beside);
double distance(const Form& form, Vec3 p, Beside& beside);

/// Unit, out of the material.
Vec3 outward(const Surface& surface, Vec3 p);

/// The same surface, as far as lengths of `tolerance_mm` tell; with the material on the same side.
bool is_same(const Surface& a, const Surface& b, double tolerance_mm);

/// What forms are called, by their index; of those that faces may lie on.
inline constexpr std::array<std::string_view, 10> kForms{"plane",  "cylinder",  "cone", "sphere",
                                                         "torus",  "extrusion", "dome", "coil",
                                                         "spiral", "envelope"};
/// The largest radius of curvature; 0 for planes, and for cones, which have any.
double radius_of(const Form& form);

/// Where along its line the circle of an extrusion passes `p`: how far from `centre`.
double place_along(const Extrusion& extrusion, Vec3 p);

/// A point of a dome: which one of which circle.
struct DomePlace {
    Vec3 out;                         ///< Unit, from the centre of the circle to the point.
    Vec3 up;                          ///< Unit, from the centre of the arc to that of the circle.
    Vec3 along;                       ///< Unit, the way of the arc there, to greater angles.
    double cosine = 1.0, sine = 0.0;  ///< Of the angle t.
    double degrees() const;
};
/// That of the point of `dome` nearest to `p`, as far as it can be found from the one at its
/// height.
DomePlace place_on(const Dome& dome, Vec3 p);
Vec3 point_at(const Dome& dome, const DomePlace& place);
/// Where the centre of its circle is at the height of `p`, or nearest to that.
Vec3 centre_at_height(const Dome& dome, Vec3 p);

/// A point of a coil.
struct CoilPlace {
    Vec3 out;           ///< Unit, from the centre of the circle to the point.
    Vec3 centre;        ///< Of the circle.
    Vec3 way;           ///< Unit, level: where the circle goes, to greater t.
    double turn = 0.0;  ///< t, radians.
};
/// That of the point of `coil` nearest to `p`, as far as it can be found from the one at its
/// height.
CoilPlace place_on(const Coil& coil, Vec3 p);
/// Where the circle is when it is as high as `p`.
CoilPlace place_at_height(const Coil& coil, Vec3 p);

/// A point of a spiral.
struct SpiralPlace {
    double turn = 0.0;    ///< t, radians.
    Vec3 way;             ///< Where the way is, at the height of the centre.
    Vec3 along, out;      ///< Unit: the direction of the way, to greater t; across it, outwards.
    double speed = 0.0;   ///< Of the wall, mm for each radian.
    double height = 0.0;  ///< Above the centre, mm.
};
/// That of the point of `spiral` nearest to `p`, as far as it can be found from the angle of `p`.
SpiralPlace place_on(const Spiral& spiral, Vec3 p);
/// Where t is `turn`, at the height of the centre.
SpiralPlace place_at(const Spiral& spiral, double turn);

/// Between the axis and the side.
double half_angle_rad(const Cone& cone);

/// A direction at right angles to `axis` (unit), the same for all that are nearly equal: that of X
/// as far as it goes, for Z-axes X itself.
Vec3 across(Vec3 axis);

}  // namespace ncsim::brep
