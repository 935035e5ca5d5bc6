// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces on surfaces that files know as splines only.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

namespace ncsim::brep {

/// The part of a spline surface that a face lies on.
/// A dome or a coil: the circle (of a coil the half of it that goes ahead, or behind, as the face
/// does, and turns with the way), and the way; of degree 5, within 6e-10 of the radii, and the
/// parameters are angles. A patch of a dome ends where the face ends along a circle of either kind,
/// and otherwise a little farther.
/// A spiral: the wall as far as the face goes and a little beyond, within 2e-9 of the radius.
/// An envelope: likewise, around the way and along it, within 1e-6 mm, or as near as 400 knots each
/// way come.
Patch patch_of(const Part& part, const Face& face);

}  // namespace ncsim::brep
