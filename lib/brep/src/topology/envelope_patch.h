// SPDX-License-Identifier: GPL-3.0-or-later
//
// Envelopes as splines.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

namespace ncsim::brep {

/// Around the way and along it, as far as the face goes and a little beyond. Measured between the
/// knots, which are as many as it takes: within 1e-6 mm, or as near as 400 knots each way come.
Patch patch_of_envelope(const Part& part, const Face& face, const Envelope& envelope);

}  // namespace ncsim::brep
