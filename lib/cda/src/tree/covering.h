// SPDX-License-Identifier: GPL-3.0-or-later
//
// A quick proof that there is nothing: boxes are halved until each is taken by one cell. Where the
// tool has just cleared its way, cells cover each other many times over, and boxes stay few: cells
// that wait need not be taken in to find that out.
#pragma once

#include "tree/block_tree.h"

#include <cstddef>
#include <span>

namespace ncsim::cda {

struct CoveringInput {
    std::span<const Plane> window;  ///< What is to be covered lies below all of these,
    HalfBox bounds;                 ///< and in here.
    std::span<const IncomingCell* const> waiting;
    const CellTable& cells;
    std::size_t most_looks;  ///< At a cell or a plane from a box; after so many the answer is no.
};

/// Is all that the window has in the block taken by cells, those that wait included? Never claims
/// what is not so; may miss what is. O(most_looks).
bool is_covered(const BlockTree& block, const CoveringInput& input);

}  // namespace ncsim::cda
