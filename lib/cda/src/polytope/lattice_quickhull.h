// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull in integers, for bodies of a hundred points: turning tools need one at every step.
#pragma once

#include "ncsim/cda/lattice.h"

#include "polytope/qhull.h"

#include <optional>
#include <span>

namespace ncsim::cda {

/// The convex hull in triangles, which close: each edge belongs to two of them. Exact, so that
/// triangles of one facet lie in one plane. Nothing where the points lie in a plane, are farther
/// apart than 2^29 units, or one lies on the line of an edge beyond its end as it is added: ask
/// quickhull() then. Expected O(n log n).
///
/// Source: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
std::optional<HullFacets> lattice_quickhull(std::span<const LatticePoint> points);

}  // namespace ncsim::cda
