// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mean distance between a polytope and the round tool.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "polytope/ring_polygon.h"
#include "polytope/strip_costs.h"

#include <vector>

namespace ncsim::toolpath {

/// Returns how much farther the polytope reaches than the round tool, in lattice units, on average
/// over the lower sides of rounded corners, weighted by the fourth power of the cosine between
/// normal and axis, because rounded tools finish gentle slopes. The average is taken over a grid of
/// normals. Cost: O(rings).
double mean_excess(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                   const std::vector<Ring>& rings, double unit_mm);

}  // namespace ncsim::toolpath
