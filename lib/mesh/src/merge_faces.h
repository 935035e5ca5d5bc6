// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merging of coplanar adjacent faces, so each visible face of the part is a face.
#pragma once

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/cda/boundary.h"

#include "half_edges.h"

#include <cstdint>
#include <vector>

namespace ncsim::mesh {

/// A boundary with merged faces.
struct MergedFaces {
    /// The merged surface, with the vertices of the original, some of which may be unused. `origin`
    /// of a face is the smallest origin of the merged faces.
    cda::Boundary boundary;
    /// For each merged face, the origins of the original faces, ascending, without repetition.
    std::vector<std::vector<cda::Origin>> origins;
    std::vector<std::uint32_t> group;  ///< For each merged face, the representative of the group.
};

/// Merges each of `groups` into a face. A group holds the numbers of connected faces that lie
/// approximately in the plane of the group's first face. A group without an outline, which is a
/// whole shell, gets no face. All vertices stay.
/// Cost: O(n log n).
MergedFaces merge_groups(const cda::Boundary& boundary, DisjointSets& groups);

}  // namespace ncsim::mesh
