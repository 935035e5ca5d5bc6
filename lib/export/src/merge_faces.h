// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary as a person counts its faces: what lies in one plane and hangs together is one.
#pragma once

#include "ncsim/cda/boundary.h"

#include "half_edges.h"

#include <vector>

namespace ncsim::exporter {

struct MergedFaces {
    /// The merged surface, with the vertices of the old one (some of them unused now).
    /// `origin` of a face is the smallest of those it is made of.
    cda::Boundary boundary;
    /// For each merged face the origins of the faces it is made of, ascending, each once.
    std::vector<std::vector<cda::Origin>> origins;
};

/// Makes one face of each of `groups`, which hold the numbers of faces that hang together and lie
/// in the plane of the group's first one, more or less. All vertices stay. O(n log n).
MergedFaces merge_groups(const cda::Boundary& boundary, Groups& groups);

/// Joins faces that share an edge and lie in the same plane, and leaves out vertices at which only
/// two faces remain: their edges go straight on. Nothing moves, so the surface stays closed and
/// its volume the same. Planes are the same if their normals are equal to the last bit, as
/// those computed from one exact plane are. O(n log n).
MergedFaces merge_coplanar(const cda::Boundary& boundary);

}  // namespace ncsim::exporter
