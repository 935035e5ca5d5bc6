// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the way of a tool bends: how what it leaves before the bend meets what it leaves after it.
#pragma once

#include "ncsim/brep/surface.h"

#include <array>
#include <optional>

namespace ncsim::brep {

/// Of two pipes that bend into each other: the plane near `p` in which they meet.
std::optional<Form> mitre_of(const Form& a, const Form& b, Vec3 p);

/// Level circles of one radius that move along two lines meet in a circle and in an ellipse: which
/// of the two points in which these cross is nearer to `p`. There an edge may go on from the one to
/// the other.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p);

/// The same where the one of `p` and `q` lies on the circle and the other on the ellipse: the one
/// nearer to that on the circle; of two pipes the one nearer to `past`, a point of the edge.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 past);

/// Of such forms: if `p` lies on the circle alone, the plane of the ellipse.
std::optional<Form> ellipse_of_bend(const Form& a, const Form& b, Vec3 p);

/// Cylinders of one radius whose axes cross meet in two ellipses, in the planes between the axes.
std::optional<std::array<Plane, 2>> mitres(const Cylinder& a, const Cylinder& b);

/// Of level circles of one radius that move along lines the plane of the one where the lines cross,
/// its centre as origin, and the plane of the ellipse in which the circles of every height meet. A
/// cylinder moves along its axis.
std::optional<std::array<Plane, 2>> bends(const Form& a, const Form& b);

/// What a circle passes that moves along a line; of a cylinder about `axis`, that along it.
std::optional<Extrusion> moved_circle(const Form& form, Vec3 axis);

/// Where the circle of a dome or a coil and one of the same size that moves otherwise are one: the
/// centre nearest to the height of `p`.
std::optional<Vec3> common_circle(const Form& a, const Form& b, Vec3 p);

/// Where the tool goes through what it left before, a point beside its circle is of another one,
/// which was behind there, or before it.
bool is_of_circle(const Coil& coil, Vec3 centre, Vec3 p);
bool is_of_circle(const Dome& dome, Vec3 centre, Vec3 p);

/// Than to the other one.
bool is_nearer(const Plane& one, const Plane& other, Vec3 p);

}  // namespace ncsim::brep
