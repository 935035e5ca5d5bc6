// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces on surfaces that files know as splines only.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// A surface each of whose points is the sum of one of each spline; so are its control points. The
/// normal is that of `around` with `along`: outwards.
struct Patch {
    Spline around, along;
};

/// Of a dome, as far as the face on it goes and a little beyond: the circle, about zero, and the
/// arc. Within 2e-10 of the radii.
Patch patch_of(const Part& part, const Face& face);

}  // namespace ncsim::brep
