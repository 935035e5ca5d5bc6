// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fewer faces for the same part, within a tolerance.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/mesh/simplified.h"

namespace ncsim::mesh {

/// Tolerance in mm, below the resolution of machines and gauges but above the 10 nm of the lattice,
/// which splits a flat wall into several facets. With this tolerance, the faces are those that are
/// visible on the part.
inline constexpr double kFlatTolerance = 1e-4;

/// Simplifies `boundary` within a distance of a quarter of `tolerance_mm`, or less if the steps add
/// up to more than the tolerance somewhere:
/// - Thin features are removed: short edges become vertices, thin bands between two faces become
///   edges.
/// - Adjacent faces that lie in one plane within that distance become one face.
/// - Vertices that lie within that distance of a straight edge between two faces are removed.
///
/// Faces whose normals differ by more than 15° stay separate, unless one is thinner than the
/// tolerance. If `lines` is provided, faces cut by different program lines stay separate too, with
/// the same exception. With a tolerance of 0, only exactly coplanar faces are joined.
///
/// Requires: `tolerance_mm` >= 0.
/// Guarantees: a closed surface stays closed, with the same shells, except that shells thinner than
///     the tolerance vanish; parts connected through a thin band or a short edge stay connected.
///     Faces are flat within half the tolerance, not exactly.
/// Cost: O(n log n) expected.
Simplified simplify(const cda::Boundary& boundary, double tolerance_mm,
                    const Provenance* lines = nullptr);

/// Returns the faces of simplify(), without triangles, and without a measurement where the steps
/// cannot add up to more than the tolerance.
/// Requires: `tolerance_mm` >= 0.
/// Cost: about half of that of simplify().
JoinedFaces join_faces(const cda::Boundary& boundary, double tolerance_mm,
                       const Provenance* lines = nullptr);

}  // namespace ncsim::mesh
