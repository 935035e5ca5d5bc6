// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners that are one to readers.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Where planes alone meet, in lines: the ends of edges of these faces that are shorter than
/// `least_mm` become one corner, whatever hangs together by them, the shortest first, as long as no
/// corner goes farther than twice that. Edges of that length go, and faces of which nothing is left
/// keep an empty loop. There may be edges with nothing between them then (spikes.h), and loops that
/// come back to a corner (non_simple_faces.h). True: something has gone. O(n log n) for n edges.
bool collapse_short_edges(Part& part, const std::vector<std::uint32_t>& faces, double least_mm);

}  // namespace ncsim::brep
