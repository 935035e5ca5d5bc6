// SPDX-License-Identifier: GPL-3.0-or-later
//
// A quick proof that no material is left: boxes are halved until a single cell covers each box.
// If the tool has just cleared a path, cells overlap many times, and few boxes suffice. Waiting
// cells need not be inserted for the proof.
#pragma once

#include "tree/block_tree.h"

#include <cstddef>
#include <span>

namespace ncsim::cda {

/// Input of is_covered().
struct CoveringInput {
    std::span<const Plane> window;  ///< The region to be covered is below all these planes
    HalfBox bounds;                 ///< Box around the region to be covered.
    std::span<const IncomingCell* const> pending;
    const CellTable& cells;
    /// Limit on box–cell and box–plane tests; beyond the limit the answer is false.
    std::size_t test_limit;
};

/// True if the cells of the block, including waiting cells, cover the part of the window in the
/// block. A positive answer is exact; a negative answer may be wrong.
/// Cost: O(test_limit).
bool is_covered(const BlockTree& block, const CoveringInput& input);

}  // namespace ncsim::cda
