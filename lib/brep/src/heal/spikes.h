// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spikes: pairs of coincident edges of a face, with no area between the two.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Erases each pair of straight edges that a planar face uses in opposite directions between the
/// same corners, anywhere in its loops. The faces beyond both edges become adjacent. The pair may
/// also be a single edge with the face on both sides. Loops of the face are merged or divided, so
/// the first loop may no longer be the outline. A face without edges keeps an empty loop.
/// Returns: true if the part changed.
/// Cost: O(n log n) for n edges, and again O(m log m) for a face of m edges with each pair erased.
bool remove_spikes(Part& part);

}  // namespace ncsim::brep
