// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners of tool paths: intersections of the surfaces that a tool leaves before and after a
// corner.
#pragma once

#include "ncsim/brep/surface_forms.h"

#include <array>
#include <optional>

namespace ncsim::brep {

/// Returns the plane near `p` in which the surfaces on both sides of a corner meet.
std::optional<Form> mitre_plane(const Form& a, const Form& b, Vec3 p);

/// Returns a point in which an edge may change from a circle to an ellipse. Level circles of equal
/// radius that move along two lines meet in a circle and in an ellipse; these curves cross in two
/// points, and the result is the point nearer to `p`.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p);

/// Returns the same if `p` or `q` lies on the circle alone and the remaining point on the ellipse
/// alone: the crossing nearer to the point on the circle. For two cylinders, returns the crossing
/// nearer to `past`, a point of the edge.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 past);

/// Returns the plane of the ellipse if `p` lies on the circle alone.
std::optional<Form> ellipse_of_bend(const Form& a, const Form& b, Vec3 p);

/// Returns the planes of the two ellipses in which cylinders of equal radius with crossing axes
/// meet. The planes bisect the axes.
std::optional<std::array<Plane, 2>> mitre_planes(const Cylinder& a, const Cylinder& b);

/// Returns the planes in which two level circles of equal radius that move along crossing lines
/// meet: the plane of the circle where the lines cross, with the circle's centre as origin, and the
/// plane of the ellipse in which the circles of every height meet. A cylinder is a circle that
/// moves along its axis.
std::optional<std::array<Plane, 2>> bend_planes(const Form& a, const Form& b);

/// Returns `form` as a circle that moves along a line: an extrusion, or a cylinder about `axis`.
std::optional<Extrusion> moved_circle(const Form& form, Vec3 axis);

/// Returns the centre of the circle that a dome or a coil has in common with the surface of an
/// equal circle on a different path. If there are several, returns the centre nearest to the height
/// of `p`.
std::optional<Vec3> common_circle(const Form& a, const Form& b, Vec3 p);

/// True if `p` belongs to the circle about `centre`. Where a tool crosses its own path, a point
/// near the circle may belong to a circle of another time.
bool belongs_to_circle(const Coil& coil, Vec3 centre, Vec3 p);
bool belongs_to_circle(const Dome& dome, Vec3 centre, Vec3 p);

/// Returns the point nearest to `p` in which a ball that crossed its own path touched both grooves:
/// a straight one and one along an arc, or two along arcs, of equal radius. There the surfaces are
/// tangent, and their curves of intersection cross.
std::optional<Vec3> crossing_of_grooves(const Form& a, const Form& b, Vec3 p);

/// True if `p` is nearer to the first plane than to the second.
bool is_nearer(const Plane& one, const Plane& other, Vec3 p);

}  // namespace ncsim::brep
