// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same part with fewer faces, within a tolerance: for readers that have one of their own.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"
#include "ncsim/export/simplified.h"

namespace ncsim::exporter {

/// mm. Below what any machine or gauge sees, above the 10 nm of the lattice that makes several
/// facets of one flat wall: within it, faces are those that a person counts on the part.
inline constexpr double kFlatTolerance = 1e-4;

/// Takes out what is thinner than a quarter of `tolerance_mm` (edges become vertices, bands between
/// two faces become edges), makes one face of neighbours that lie in one plane within a quarter of
/// it, and leaves out vertices that lie within a quarter of it on a straight edge between two
/// faces; less than a quarter, if that adds up to more than the tolerance somewhere. Faces that
/// turn away from each other by more than 15° stay apart, unless one of them is thinner than the
/// tolerance.
///
/// A closed surface stays closed, with the same shells, save those thinner than the tolerance,
/// which vanish: what hangs together through a thin band or a short edge keeps it.
/// Faces are flat within half the tolerance, no longer exactly. Where `lines` is given, faces
/// that different program lines cut stay apart too, with the same exception. Requires a tolerance ≥
/// 0; with 0, only what is exactly coplanar is joined. Expected O(n log n).
Simplified simplify(const cda::Boundary& boundary, double tolerance_mm,
                    const Provenance* lines = nullptr);

}  // namespace ncsim::exporter
