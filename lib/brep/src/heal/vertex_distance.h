// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where corners are nearer to each other than readers can tell from nothing.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Where planes alone meet, in lines: corners that are off their planes move onto them, or nearer
/// to them, by less than 1e-4 mm. Edges shorter than 1e-5 mm, or so short that readers lose them
/// (reader_lengths()), become points, if nothing hangs together by them; those of the others that
/// are shorter than 3e-7 mm become 1e-5 mm long. Readers take what is nearer than 1e-7 mm for one
/// point, and find the surface open there. Edges that are no longer used stay behind; edges there
/// and back one after the other, between which nothing is, are not used.
///
/// Planes that touch themselves: readers part them, but not always well. So their edges are divided
/// where a corner of theirs lies on them within 1e-5 mm, or within the widths of both, and where
/// their loops come back to a corner they become several loops, and several faces where these lie
/// beside each other. The same within 1e-4 mm for those whose loops cross then, and for those that
/// are narrower than their corners are off the planes around these; where there still are any,
/// their edges shorter than 1.5e-5 mm (3e-5, 1e-4, if there are none) become points, whatever hangs
/// together by them, for what has nothing between then goes, and it all begins again.
///
/// Of each face: which one it was, or was part of. O(n log n) for n edges.
std::vector<std::uint32_t> enforce_min_vertex_distance(Part& part);

}  // namespace ncsim::brep
