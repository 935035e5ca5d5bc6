// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facet rule, leaf by leaf: the visible remainders of the facets of a block. See docs/cda.md,
// "The facet rule".
#pragma once

#include "polytope/filtered_polygon.h"
#include "surface/outlines.h"
#include "tree/block_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Input of evaluations, the same for all blocks.
struct EvaluationInput {
    std::span<const Plane> stock;
    /// If not null: evaluates the surface of the intersection of the part and these halfspaces,
    /// instead of the surface of the part.
    const std::vector<Plane>* window = nullptr;
    const CellTable& cells;
    /// Reference point of volumes in lattice units; rounding is smallest near the middle.
    Vec3 centre;
    bool only_first = false;  ///< Stop at the first piece of surface.
};

/// Result for a block.
struct Evaluation {
    Outlines outlines;
    double volume = 0.0;  ///< Cubic lattice units; a volume only as a sum over all blocks.
    std::uint64_t leaves = 0, facets_tested = 0, facets_alive = 0;
};

/// Evaluates a block. Cost: O(leaves · (planes of a leaf)²).
Evaluation evaluate(const BlockTree& block, const EvaluationInput& input);

}  // namespace ncsim::cda
