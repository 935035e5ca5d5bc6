// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners that CAD readers take for a single corner.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Merges the ends of edges of `faces` that are shorter than `least_mm`, the shortest first, even
/// if the topology changes. Only edges are collapsed at whose ends planes and lines alone meet, and
/// no vertex moves by more than 2 `least_mm`. Collapsed edges are erased from planar faces; a face
/// without edges keeps an empty loop. The result may have spikes (spikes.h), and loops that return
/// to a corner (non_simple_faces.h).
/// Returns: true if an edge was collapsed.
/// Cost: O(n log n) for n edges.
bool collapse_short_edges(Part& part, const std::vector<std::uint32_t>& faces, double least_mm);

}  // namespace ncsim::brep
