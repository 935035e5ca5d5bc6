// SPDX-License-Identifier: GPL-3.0-or-later
//
// A convex body as the kernel takes it in: halfspaces, and who made it.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/vec.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace ncsim::cda {

/// Directions of facets that many cells share: those of one body that moved without turning. Which
/// facets of such cells can be what is seen in a box is found for all of them at once.
struct FacetNormals {
    std::vector<double> x, y, z;  ///< Whole numbers, as in the planes.

    std::size_t size() const { return x.size(); }
};

/// What a body did step by step where one cell stands for all: it went straight on.
struct StraightSteps {
    struct Step {
        Origin origin = kStockOrigin;
        double end = 1.0;  ///< Of the step, as a share of the way: ascending to 1.
        Box bounds;        ///< Of the hull of the step alone, mm; empty where that took nothing.
    };
    LatticePoint way;  ///< From the start of the first to the end of the last.
    std::vector<Step> steps;
};

/// The intersection of halfspaces; bounded. Redundant planes are allowed, but none stands twice.
/// `bounds` (mm) encloses it, not necessarily tightly; it is used to reject, never to decide.
struct Cell {
    std::vector<Plane> planes;
    Box bounds;
    Origin origin = kStockOrigin;
    /// Where cells have facets in one plane, the wall is that of the cell with the lower rank; of
    /// those with the same, that of the earlier origin, then of the cell that came first. Any ranks
    /// give the same part; if what reaches farther has the lower one, the fewest cells are kept.
    std::int32_t rank = kFirstRank;
    static constexpr std::int32_t kFirstRank = std::numeric_limits<std::int32_t>::min();
    /// Of the first planes, in their order; null if they are nobody else's. Who changes planes
    /// resets it.
    std::shared_ptr<const FacetNormals> normals;
    /// Of the hull of a body that went straight on: whose share is what of it, for accounts. Its
    /// first planes are those of the body, the others are along the way. Null: all is the origin's.
    std::shared_ptr<const StraightSteps> steps = nullptr;
};

/// The box with the corners `min` and `max`, in lattice units.
Cell box_cell(LatticePoint min, LatticePoint max, const Lattice& lattice,
              Origin origin = kStockOrigin);

}  // namespace ncsim::cda
