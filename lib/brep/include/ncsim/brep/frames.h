// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the parameters of surfaces start, so that no edge of a face crosses a seam.
#pragma once

#include "ncsim/brep/part.h"

#include <optional>

namespace ncsim::brep {

/// Is the apex of its cone inside of the face?
bool has_tip(const Part& part, const Face& face);

/// Frames for curved faces of `part`: the x axis points to where nothing of the face is, so that no
/// edge crosses it; where it goes all round, to a vertex. The axis of a sphere passes by the face
/// as far away as it can.
Frame frame_for(const Part& part, const Face& face);

/// Returns the frame that files give the surface of `face`: its own one, but for spheres, whose
/// axis makes all edges lines of parameters if an axis does.
Frame frame_in_file(const Part& part, const Face& face);

/// Of a ramp that rises by less than 0.1 of its length, with a corner beside its side: to which
/// side, level and unit, the half of its circle looks on which the whole face is, that in front of
/// the way or that behind it. There both are nearly as high at one place, and readers cannot tell
/// them apart. Nothing of other faces.
std::optional<Vec3> half_of_ramp(const Part& part, const Face& face);

}  // namespace ncsim::brep
