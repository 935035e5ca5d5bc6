// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that a rotating tool leaves on a part, in the classes that CAD systems use. mm, frame W.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/brep/envelope.h"

#include <array>
#include <string_view>
#include <variant>

namespace ncsim::brep {

/// Unbounded plane.
struct Plane {
    Vec3 origin, normal;  ///< A point on the plane; the unit normal.
    bool operator==(const Plane&) const = default;
};
/// Circular cylinder of unbounded length.
struct Cylinder {
    Vec3 origin, axis;  ///< A point on the axis; the unit direction.
    double radius = 0.0;
    bool operator==(const Cylinder&) const = default;
};
/// One nappe of a cone, on the side of the apex to which `axis` points.
struct Cone {
    Vec3 apex, axis;
    double slope = 0.0;  ///< Radius divided by the height above the apex, > 0.
    bool operator==(const Cone&) const = default;
};
/// Sphere, mm.
struct Sphere {
    Vec3 centre;
    double radius = 0.0;
    bool operator==(const Sphere&) const = default;
};
/// Torus; a spindle, which intersects its own axis, if major <= minor (is_spindle()).
struct Torus {
    Vec3 centre, axis;
    double major = 0.0, minor = 0.0;
    bool operator==(const Torus&) const = default;
};

/// Elliptic cylinder: the surface swept by a circle that moves along a line oblique to the circle's
/// plane.
struct Extrusion {
    /// Centre of the circle at any position; unit normal of the circle's plane.
    Vec3 centre, axis;
    Vec3 along;  ///< Unit direction of the line, on the side to which `axis` points.
    double radius = 0.0;
    bool operator==(const Extrusion&) const = default;
};

/// Half of a Bohemian dome: the surface swept by a circle that moves, without turning, along an arc
/// perpendicular to the circle's plane. The circle's centre is at centre + reach (cos t ahead + sin
/// t axis), t from -90 to 90 degrees.
struct Dome {
    Vec3 centre, axis;  ///< Centre of the arc; unit normal of the circle's plane.
    Vec3 ahead;         ///< Unit, perpendicular to `axis`, towards the side on which the half lies.
    double reach = 0.0, radius = 0.0;
    bool operator==(const Dome&) const = default;
};

/// Surface swept by a circle that moves, without turning, along a helix about an axis perpendicular
/// to the circle's plane. The circle's centre is at centre + reach (cos t ahead + sin t side) +
/// lead t axis, t in radians, side = axis x ahead.
struct Coil {
    Vec3 centre, axis;  ///< Centre of the helix at t = 0; unit direction.
    Vec3 ahead;         ///< Unit, perpendicular to `axis`.
    double reach = 0.0, radius = 0.0;
    double lead = 0.0;  ///< mm per radian, not 0.
    bool operator==(const Coil&) const = default;
};

/// Wall along a path whose distance from an axis changes linearly with the angle about the axis.
/// Arcs whose ends differ in radius leave such walls. The wall is parallel to the axis, at the
/// distance `offset` from the path, outwards if positive. The path is at centre + (reach + lead t)
/// (cos t ahead + sin t side), t in radians from -pi to pi, side = axis x ahead.
struct Spiral {
    Vec3 centre, axis;  ///< A point on the axis; the unit direction.
    Vec3 ahead;         ///< Unit, perpendicular to `axis`, towards the middle of the path.
    double reach = 0.0, lead = 0.0;  ///< mm; mm per radian.
    double offset = 0.0;
    bool operator==(const Spiral&) const = default;
};

/// Surface of all lines that are perpendicular to an axis and meet both the axis and a helix about
/// the axis. No face lies on a helicoid: the helicoid crosses a coil and the walls tangent to the
/// coil along the curve of tangency.
struct Helicoid {
    Vec3 centre, axis, ahead;
    double lead = 0.0;  ///< mm per radian, as in Coil.
    bool operator==(const Helicoid&) const = default;
};

using Form = std::variant<Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Dome, Coil, Spiral,
                          Envelope, Helicoid, Characteristic, Trail>;

/// True if the torus is as thick as wide or thicker: major <= minor (1 + 1e-6). Faces on a spindle
/// lie below the centre as seen along the axis, on the side away from the axis. A tip of the
/// spindle may be a corner of a face or inside a face (has_tip()).
bool is_spindle(const Torus& torus);
/// Returns the angle around the tube of the tip below the centre of a spindle, degrees from the
/// outermost circle, from -180 to -90.
double tip_degrees(const Torus& spindle);

/// A form and the side of the form on which the material is.
struct Surface {
    Form form;
    /// True if the material is where distance() > 0, as around the tool that left the surface.
    /// Always false for planes.
    bool is_hollow = false;
    bool operator==(const Surface&) const = default;
};

/// Returns the signed distance from the form in mm, positive outside (in front of a plane). For
/// cones, the nappe is continued beyond the apex. For Helicoid, Characteristic and Trail, the
/// result is exact to first order only.
double distance(const Form& form, Vec3 p);
/// Returns the unit gradient of distance(); zero where undefined (on an axis, in a centre).
Vec3 gradient(const Form& form, Vec3 p);
/// Distance and gradient, computed together because projecting a point onto a swept surface costs
/// the most.
struct DistanceAndGradient {
    double distance = 0.0;
    Vec3 gradient;
};
DistanceAndGradient evaluate(const Form& form, Vec3 p);

/// Returns the same as the overloads with two parameters, for consecutive points: on envelopes the
/// search for the nearest time starts from the last point's time, which the third parameter holds.
DistanceAndGradient evaluate(const Form& form, Vec3 p, ProjectionSeed& seed);
double distance(const Form& form, Vec3 p, ProjectionSeed& seed);

/// Returns the unit normal that points out of the material.
Vec3 outward(const Surface& surface, Vec3 p);

/// True if both surfaces agree within `tolerance_mm`, with the material on the same side. Angles
/// are compared as the deviation over a length of 100 mm.
bool is_same(const Surface& a, const Surface& b, double tolerance_mm);

/// Names of the forms on which faces may lie, by their index in Form.
inline constexpr std::array<std::string_view, 10> kForms{"plane",  "cylinder",  "cone", "sphere",
                                                         "torus",  "extrusion", "dome", "coil",
                                                         "spiral", "envelope"};
/// Returns the largest radius of curvature in mm, nearly; 0 for planes, and for cones, whose radius
/// is unbounded.
double radius_of(const Form& form);

/// Returns the distance from `centre` along the line at which the plane of the circle contains `p`,
/// mm.
double place_along(const Extrusion& extrusion, Vec3 p);

/// Point on a dome, by the angles on the circle and on the arc.
struct DomePlace {
    Vec3 out;  ///< Unit, from the centre of the circle to the point.
    /// Unit, from the centre of the arc to the centre of the circle.
    Vec3 up;
    Vec3 along;                       ///< Unit tangent of the arc, to greater angles.
    double cosine = 1.0, sine = 0.0;  ///< Cosine and sine of t.
    /// Returns t, degrees.
    double degrees() const;
};
/// Returns the point on `dome` nearest to `p`. Newton's method starts at the height of `p`, so the
/// result may be a local minimum.
DomePlace project_onto(const Dome& dome, Vec3 p);
/// Returns the point at `place`.
Vec3 point_at(const Dome& dome, const DomePlace& place);
/// Returns the centre of the circle at the height of `p`, or at the nearest height that the arc
/// reaches.
Vec3 centre_at_height(const Dome& dome, Vec3 p);

/// Point on a coil.
struct CoilPlace {
    Vec3 out;     ///< Unit, from the centre of the circle to the point.
    Vec3 centre;  ///< Centre of the circle.
    /// Unit, perpendicular to the axis: direction in which the circle moves, to greater t.
    Vec3 motion;
    double turn = 0.0;  ///< t, radians.
};
/// Returns the point on `coil` nearest to `p`. Newton's method starts at the height of `p`, so the
/// result may be a local minimum.
CoilPlace project_onto(const Coil& coil, Vec3 p);
/// Returns the place of the circle at the height of `p`, with `out` towards `p`.
CoilPlace place_at_height(const Coil& coil, Vec3 p);

/// Point on a spiral.
struct SpiralPlace {
    double turn = 0.0;  ///< t, radians.
    Vec3 path_point;    ///< Point on the path, at the height of the centre.
    /// Unit: tangent of the path, to greater t; perpendicular to the path, outwards.
    Vec3 along, out;
    double speed = 0.0;   ///< Speed of the wall, mm per radian.
    double height = 0.0;  ///< Above the centre, mm.
};
/// Returns the point on `spiral` nearest to `p`. Newton's method starts at the angle of `p`, so the
/// result may be a local minimum.
SpiralPlace project_onto(const Spiral& spiral, Vec3 p);
/// Returns the place where t is `turn`, at the height of the centre.
SpiralPlace place_at(const Spiral& spiral, double turn);

/// Returns the angle between the axis and the side, rad.
double half_angle_rad(const Cone& cone);

/// Returns a unit vector perpendicular to `axis` (unit): the projection of X, or of Y if |axis.x|
/// >= 0.9. The result is X itself for axes along Z, and nearly equal for nearly equal axes.
Vec3 any_perpendicular(Vec3 axis);

}  // namespace ncsim::brep
