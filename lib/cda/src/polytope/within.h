// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does one cell lie within another? Asked of hulls of steps and what covers a whole turn of them:
// who knows that before cells go down the tree need not send the others.
#pragma once

#include "ncsim/cda/cell.h"

namespace ncsim::cda {

/// Has `outer` all of `inner` that is in `place` (units)? Decided in integers; never claims what is
/// not so. Finds it where the planes of `outer` that cut the place have the normal of one of
/// `inner`, or are upright and lie between two upright ones that make a corner of `inner`. O(planes
/// of the one · planes of the other).
bool lies_within(const Cell& inner, const Cell& outer, const Box& place);

}  // namespace ncsim::cda
