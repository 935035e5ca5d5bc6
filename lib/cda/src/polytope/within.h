// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment of a cell in a second cell. Hulls of steps that lie within the cell of a whole turn
// need not be inserted into the tree.
#pragma once

#include "ncsim/cda/cell.h"

namespace ncsim::cda {

/// True if `outer` contains the part of `inner` in `place` (units). Decided in integers; a positive
/// answer is exact, a negative answer may be wrong. The proof needs, for each plane of `outer` that
/// cuts `place`, a plane of `inner` with the same normal, or two upright planes of `inner` that
/// form a corner around an upright plane of `outer`.
/// Cost: O(planes of `inner` · planes of `outer`).
bool lies_within(const Cell& inner, const Cell& outer, const Box& place);

}  // namespace ncsim::cda
