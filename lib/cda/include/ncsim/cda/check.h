// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of surfaces for tests and reports.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"

#include <cstdint>

namespace ncsim::cda {

/// Result of check(): counts of edges and a measure of closedness.
struct SurfaceCheck {
    std::uint64_t edges = 0;  ///< Number of directed edges.
    /// Edges without exactly one partner in the opposite direction.
    std::uint64_t unpaired_edges = 0;
    std::uint64_t repeated_edges = 0;  ///< Edges that occur more than once in the same direction.
    /// |Σ n·A| / Σ A: 0 for a closed surface, up to rounding.
    double relative_area_sum = 0.0;

    bool is_closed() const { return unpaired_edges == 0 && repeated_edges == 0; }
};

/// Counts edges without a partner, and measures the sum of all area vectors.
/// Cost: O(n log n) for n edges.
SurfaceCheck check(const Boundary& boundary);
SurfaceCheck check(const TriangleMesh& mesh);

/// True if each directed edge occurs as often as the opposite edge. Compares sums of 64-bit hashes,
/// so an open surface passes with probability 2^-64.
/// Cost: O(n) for n edges.
bool is_closed(const Boundary& boundary);

/// Returns the enclosed volume in mm³.
double volume(const TriangleMesh& mesh);

}  // namespace ncsim::cda
