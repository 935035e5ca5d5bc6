// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of envelopes with surfaces of the same tool, on its path and at rest.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface_forms.h"

#include <optional>

namespace ncsim::brep {

/// Returns tangency_surface() of contact.h for an envelope as the second form.
std::optional<Form> envelope_tangency_surface(const Form& a, const Envelope& b);

/// True for an envelope of a tool whose axis turns. The facets of such envelopes come from hulls of
/// poses, with needles between the hulls.
bool is_of_turning_tool(const Form& form);

/// Returns the hinge of two ball envelopes at a corner of the path, for tools that turn. The
/// envelopes cross in a single curve and are tangent in the two points of the curve that lie
/// perpendicular to both directions of motion. The result is the tangency point on the curve from
/// `from` past `past` to `to`.
std::optional<Vec3> hinge_of(const Form& a, const Form& b, Vec3 from, Vec3 past, Vec3 to);

/// Returns the plane, nearly, in which the envelope of a ball on an arc meets the surface that the
/// ball left before or after it. The plane bisects the directions of motion, as the true curve does
/// in the corner of the path. Empty if the forms have no ball and no end in common, or no corner.
std::optional<Plane> rough_mitre_plane(const Form& a, const Form& b);

/// Returns by how much the edge between two such surfaces is farther out than the ball in the
/// corner, where it continues the envelope beyond the end of its path, mm: the depth of the lune
/// that the ball leaves between both. 0 where the path bends to the other side.
double depth_of_lune(const Form& a, const Form& b, const Track& edge);

/// Returns the end of the path (0 or 1) at which the tool's axis is the given line.
std::optional<double> end_on_axis(const Envelope& envelope, Vec3 origin, Vec3 axis);
/// Returns the end of the path at which lowest_centre() is at `centre`; on straight paths, any
/// time.
std::optional<double> end_at(const Envelope& envelope, Vec3 centre);

}  // namespace ncsim::brep
