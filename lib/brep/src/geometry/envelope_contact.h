// SPDX-License-Identifier: GPL-3.0-or-later
//
// How envelopes meet other surfaces: those of their own tool on its way, and where it stood.
#pragma once

#include "ncsim/brep/surface.h"

#include <optional>

namespace ncsim::brep {

/// As touch() of contact.h; the envelope comes second.
std::optional<Form> touch_envelope(const Form& a, const Envelope& b);

/// An envelope of one. Its facets come from hulls of poses, which have needles between them.
bool is_of_turning_tool(const Form& form);

/// Where a ball bends, what it leaves before and after cross in one curve, and touch in the two
/// points of it that look across both ways. That one of them that lies on the curve from one point
/// to another past a third, for tools that turn.
std::optional<Vec3> hinge_of(const Form& a, const Form& b, Vec3 from, Vec3 past, Vec3 to);

/// The end of its way at which the tool's axis is that line, or passes there with the lowest centre
/// of the element; on straight ways any place.
std::optional<double> end_on_axis(const Envelope& envelope, Vec3 origin, Vec3 axis);
std::optional<double> end_at(const Envelope& envelope, Vec3 centre);

}  // namespace ncsim::brep
