// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges with nothing between them.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Two straight edges of a face there and back between the same corners, one after the other, or
/// anywhere in a plane, have nothing between them: they go, and what is beyond them meets. So does
/// an edge that has one plane on both sides. Of planes, loops become one or several, and the first
/// is not always the outline any more. Faces of which nothing is left keep an empty loop. True:
/// something has gone. O(n log n) for n edges, and as much for a face each time that something
/// goes.
bool remove_spikes(Part& part);

}  // namespace ncsim::brep
