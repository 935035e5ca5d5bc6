// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull in integers, for bodies of about a hundred points. Rotary moves need a hull at every
// step.
#pragma once

#include "ncsim/cda/lattice.h"

#include "polytope/qhull.h"

#include <optional>
#include <span>

namespace ncsim::cda {

/// Returns the convex hull in triangles, closed: each edge belongs to two triangles. Exact, so
/// triangles of one facet lie in one plane. Empty if the points lie in a plane, are farther apart
/// than 2^29 units, or an added point lies on the line of an edge outside of the edge; call
/// quickhull() then.
/// Cost: expected O(n log n).
/// Source: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
std::optional<HullFacets> lattice_quickhull(std::span<const LatticePoint> points);

}  // namespace ncsim::cda
