// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames of surfaces, chosen so that no edge of a face crosses the seam of the parameters.
#pragma once

#include "ncsim/brep/part.h"

#include <optional>

namespace ncsim::brep {

/// True if the face lies on a cone and contains its apex, or on a spindle (is_spindle()) and
/// contains the tip.
bool has_tip(const Part& part, const Face& face);

/// Returns the frame for the surface of `face`. The x axis points to the middle of the widest angle
/// that the face does not cover, so no edge crosses the seam; if the face goes all round, the x
/// axis points to a vertex. The axis of a sphere keeps as far from the loops as possible and does
/// not pass through the face. Coils, spirals and envelopes keep the frame of their form.
Frame frame_for(const Part& part, const Face& face);

/// Returns the frame that files give the surface of `face`: the face's own frame, except for
/// spheres with an axis about which all edges are parameter lines; files use that axis.
Frame frame_in_file(const Part& part, const Face& face);

/// Returns the half of a shallow ramp on which the whole face lies. A ramp is shallow if its line
/// rises by less than 0.1 of its length. At the sides of a shallow ramp, the half of the circle in
/// front and the half behind are nearly at the same height, so CAD readers confuse the halves.
/// Returns: a unit vector perpendicular to the axis, towards the half in front or behind; no value
/// if the face is not on a shallow extrusion, has no corner near the side of the circle, or spans
/// both halves.
std::optional<Vec3> half_of_ramp(const Part& part, const Face& face);

}  // namespace ncsim::brep
