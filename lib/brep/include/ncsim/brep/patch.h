// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces on surfaces that files know as splines only.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

namespace ncsim::brep {

/// Of a dome or a coil, as far as the face on it goes and a little beyond: the circle (of a coil
/// the half of it that goes ahead, or behind, as the face does, and turns with the way), and the
/// way. Within 4e-10 of the radii of domes, 2.4e-8 of those of coils; of a
/// spiral the wall as far as the face goes and a little beyond, within 2e-9; of an envelope
/// likewise, around the way and along it, within 1e-6 mm, or as near
/// as 400 knots each way come.
Patch patch_of(const Part& part, const Face& face);

}  // namespace ncsim::brep
