// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline patches of envelopes.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

namespace ncsim::brep {

/// Returns the patch around and along the path, to a little beyond the face. Knots are added until
/// the patch is within 3e-8 mm of the envelope between knots, or there are 400 knots in a
/// direction.
Patch patch_of_envelope(const Part& part, const Face& face, const Envelope& envelope);

}  // namespace ncsim::brep
