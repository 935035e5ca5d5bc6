// SPDX-License-Identifier: GPL-3.0-or-later
//
// A convex body as input of the kernel: halfspaces and the motion that made the body.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace ncsim::cda {

/// Facet normals that many cells share: the cells of one body that moves without rotation. Cells
/// with shared normals are compared with each other by table instead of plane by plane.
struct FacetNormals {
    std::vector<double> x, y, z;  ///< Integers, as in the planes.

    std::size_t size() const { return x.size(); }
};

/// The steps of a body that moved along a straight line, where one cell represents all steps.
struct StraightSteps {
    /// Step of one origin.
    struct Step {
        Origin origin = kStockOrigin;
        double end = 1.0;  ///< End of the step as a share of the way, ascending to 1.
        /// Bounds of the hull of this step alone, mm; empty if the step removed no volume.
        Box bounds;
    };
    LatticePoint way;  ///< Vector from the start of the first step to the end of the last step.
    std::vector<Step> steps;
};

/// A bounded intersection of halfspaces. Redundant planes are allowed; duplicate planes are not.
/// `bounds` (mm) encloses the cell, not necessarily tightly. `bounds` serves to reject, never to
/// decide.
struct Cell {
    std::vector<Plane> planes;
    Box bounds;
    Origin origin = kStockOrigin;
    /// Decides which cell owns a wall where several cells have facets in one plane: the cell with
    /// the lowest rank, then with the earliest origin, then with the lowest number. Any ranks give
    /// the same part. The fewest cells are kept if cells that reach farther have lower ranks.
    std::int32_t rank = kFirstRank;
    static constexpr std::int32_t kFirstRank = std::numeric_limits<std::int32_t>::min();
    /// Normals of the first planes, in the order of the planes; null if the cell shares normals
    /// with no other cell. Code that changes `planes` must reset this pointer.
    std::shared_ptr<const FacetNormals> normals;
    /// Steps of a body that moved along a straight line, for the account of removed volume. The
    /// first planes of the cell are the body's; the remaining planes are parallel to the way. Null:
    /// the whole removed volume belongs to `origin`.
    std::shared_ptr<const StraightSteps> steps = nullptr;
};

/// Returns the box with the corners `min` and `max`, in lattice units.
Cell box_cell(LatticePoint min, LatticePoint max, const Lattice& lattice,
              Origin origin = kStockOrigin);

}  // namespace ncsim::cda
