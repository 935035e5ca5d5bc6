// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a surface hangs together by less than readers can tell from nothing.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Edges shorter than 3e-7 mm, of a part that has planes alone, become 1e-5 mm long: readers take
/// what is nearer than 1e-7 mm for one point, and find the surface open there. Faces are flat
/// within less than simplify() leaves them.
void keep_apart(Part& part);

}  // namespace ncsim::brep
