// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary as a person counts its faces: what lies in one plane and hangs together is one.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/disjoint_sets.h"

#include "mesh/half_edges.h"

#include <cstdint>
#include <vector>

namespace ncsim::exporter {

struct MergedFaces {
    /// The merged surface, with the vertices of the old one (some of them unused now).
    /// `origin` of a face is the smallest of those it is made of.
    cda::Boundary boundary;
    /// For each merged face the origins of the faces it is made of, ascending, each once.
    std::vector<std::vector<cda::Origin>> origins;
    std::vector<std::uint32_t> group;  ///< The number that stands for it in the groups.
};

/// Makes one face of each of `groups`, which hold the numbers of faces that hang together and lie
/// in the plane of the group's first one, more or less. A group that has no outline, since it is a
/// whole shell, has no face either. All vertices stay. O(n log n).
MergedFaces merge_groups(const cda::Boundary& boundary, cda::DisjointSets& groups);

}  // namespace ncsim::exporter
