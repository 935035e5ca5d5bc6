// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planar faces that CAD readers reject or lose.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Returns the planar faces that CAD readers reject or lose, ascending:
/// - faces of crossed_planes();
/// - faces whose edges all are straight and shorter than 3e-5 mm;
/// - faces narrower than the distance of one of their corners from an adjacent plane, and faces
///   with a hole narrower than twice that distance. Loops with curved edges are not tested for
///   width.
/// Cost: O(n log n) for n evenly distributed edges.
std::vector<std::uint32_t> degenerate_planes(const Part& part);

}  // namespace ncsim::brep
