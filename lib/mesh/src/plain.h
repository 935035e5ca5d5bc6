// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test for boundaries that simplify() would not change. For these boundaries, simplify() would
// spend
// most of the time on triangles, and then join the triangles to the original faces.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/mesh/simplified.h"

#include <optional>

namespace ncsim::mesh {

/// Cosine of 15°: faces whose normals differ by more are not joined.
inline constexpr double kMinNormalCosine = 0.9659;

/// Returns the boundary with all loops in the order of simplify_any() if no face changes for
/// `share_mm` (mm, a quarter of the tolerance); nullopt if a face may change. The test is
/// sufficient and not necessary: each vertex has at least three loops, no loops of a face meet, no
/// triangle is thin, no shell is a flake, and no two adjacent faces of one line are nearly
/// coplanar.
///
/// Requires: at least one face.
/// Guarantees: faces, loops, origins and planes are equal to the result of simplify_any(); the
///     deviation is 0.
/// Cost: about that of cda::triangulate().
std::optional<Simplified> plain_boundary(const cda::Boundary& boundary, double share_mm,
                                         const Provenance* lines);

/// Simplifies any boundary as simplify() promises, or without `has_mesh` as join_faces() does.
/// Tests compare plain_boundary() with the result. Requires: at least one face.
Simplified simplify_any(const cda::Boundary& boundary, double tolerance_mm, const Provenance* lines,
                        bool has_mesh = true);

}  // namespace ncsim::mesh
