// SPDX-License-Identifier: GPL-3.0-or-later
//
// Least distances between vertices and edges that CAD readers distinguish.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Enforces least distances where planes and lines alone meet. CAD readers take points nearer than
/// 1e-7 mm for a single point, and report that the surface is open there.
/// - Corners that are off their planes move onto the planes, or nearer, by less than 1e-4 mm.
/// - Edges shorter than 1e-5 mm, or so short that CAD readers lose them (reader_lengths()), are
///   collapsed if the topology stays. Among the remaining edges,
///   edges shorter than 3e-7 mm become 1e-5 mm long.
/// - Holes smaller than 1e-5 mm are closed. Spikes (spikes.h) and pairs of faces with the same
///   edges are erased.
/// - Planar faces that touch themselves are split, because CAD readers do not always split these
///   faces correctly: edges are divided at corners of the same face within 1e-5 mm or the widths of
///   both, and loops that return to a corner are split (non_simple_faces.h).
/// - Faces of degenerate_planes() are split in the same way, within 1e-4 mm. Edges of faces that
///   are still degenerate are collapsed even if the topology changes: edges shorter than 1.5e-5 mm;
///   if there are none, edges shorter than 3e-5 mm, then 1e-4 mm. Then all steps are repeated, at
///   most 10 times in total, because the collapse may leave spikes and flat pockets to erase.
///
/// Edges that are no longer used stay in the part. Sets `is_sound` to true if the part has no
/// degenerate_planes() at the end.
/// Returns: for each face, the number of the original face of which the face is a part.
/// Cost: O(n log n) for n edges.
std::vector<std::uint32_t> enforce_min_vertex_distance(Part& part, bool* is_sound = nullptr);

}  // namespace ncsim::brep
