// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the parameters of surfaces start, so that no edge of a face crosses a seam.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Is the apex of its cone inside of the face?
bool has_tip(const Part& part, const Face& face);

/// Frames for curved faces of `part`: the x axis points to where nothing of the face is, so that no
/// edge crosses it; where it goes all round, to a vertex. The axis of a sphere passes by the face
/// as far away as it can.
Frame frame_for(const Part& part, const Face& face);

}  // namespace ncsim::brep
