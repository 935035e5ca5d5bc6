// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundaries in which simplify() would change nothing. Most of its time would go into triangles
// that are joined to the faces that they were made of.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"
#include "ncsim/export/simplified.h"

#include <optional>

namespace ncsim::exporter {

/// Cosine of 15°: faces that turn away from each other by more are not joined.
inline constexpr double kMinNormalCosine = 0.9659;

/// Returns the boundary with its loops in the order of simplify_any(), if `share_mm` (mm, a quarter
/// of the tolerance) makes no face of it larger, smaller or flatter; nothing if it may.
///
/// Guarantees: the faces, their loops, their origins and their planes are those of simplify_any();
/// the deviation is 0. The test is sufficient and not necessary: each vertex has three loops or
/// more, no loops of a face meet, no triangle is thin, no shell is a flake, and no two adjacent
/// faces of one line are nearly in one plane.
/// Requires: at least one face. Cost: about that of cda::triangulate().
std::optional<Simplified> as_plain(const cda::Boundary& boundary, double share_mm,
                                   const Provenance* lines);

/// Does what simplify() promises, for any boundary: the oracle of the tests for as_plain().
/// Requires: at least one face.
Simplified simplify_any(const cda::Boundary& boundary, double tolerance_mm,
                        const Provenance* lines);

}  // namespace ncsim::exporter
