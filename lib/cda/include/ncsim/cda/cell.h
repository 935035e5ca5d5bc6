// SPDX-License-Identifier: GPL-3.0-or-later
//
// A convex body as the kernel takes it in: halfspaces, and who made it.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// About where the facet in a plane is, in lattice units, and in which planes facets beside it are:
/// a hint where to look first, which decides nothing and may be wrong.
struct FacetHint {
    static constexpr std::size_t kNeighbours = 8;
    std::array<float, 3> min{}, max{};
    std::array<std::uint16_t, kNeighbours> neighbours{};  ///< Indices of planes of the cell.
    std::uint16_t count = 0;                              ///< Of neighbours.

    static FacetHint anywhere() {
        constexpr float kFar = 3e38F;
        FacetHint hint;
        hint.min = {-kFar, -kFar, -kFar};
        hint.max = {kFar, kFar, kFar};
        return hint;
    }
    void add_neighbour(std::size_t plane) {
        if (count < kNeighbours) neighbours[count++] = static_cast<std::uint16_t>(plane);
    }
};

/// The intersection of halfspaces; bounded. Redundant planes are allowed, but none stands twice.
/// `bounds` (mm) encloses it, not necessarily tightly; it is used to reject, never to decide.
struct Cell {
    std::vector<Plane> planes;
    Box bounds;
    Origin origin = kStockOrigin;
    /// One per plane, or none at all.
    std::vector<FacetHint> hints;
};

/// The box with the corners `min` and `max`, in lattice units.
Cell box_cell(LatticePoint min, LatticePoint max, const Lattice& lattice,
              Origin origin = kStockOrigin);

}  // namespace ncsim::cda
