// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a surface what it promises to be? For tests, for reports, for whoever doubts.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"

#include <cstdint>

namespace ncsim::cda {

struct SurfaceCheck {
    std::uint64_t edges = 0;           ///< Directed.
    std::uint64_t unpaired_edges = 0;  ///< Without exactly one partner in the other direction.
    std::uint64_t repeated_edges = 0;  ///< Standing twice in the same direction.
    /// |Σ n·A| / Σ A: 0 for a closed surface, but for rounding.
    double relative_area_sum = 0.0;

    bool is_closed() const { return unpaired_edges == 0 && repeated_edges == 0; }
};

SurfaceCheck check(const Boundary& boundary);
SurfaceCheck check(const TriangleMesh& mesh);

/// Whether each directed edge stands as often as its opposite. By a sum of 64-bit hashes, so that
/// it costs next to nothing: an open surface passes once in 2^64. O(n).
bool is_closed(const Boundary& boundary);

/// Volume enclosed by the triangles, mm³.
double volume(const TriangleMesh& mesh);

}  // namespace ncsim::cda
