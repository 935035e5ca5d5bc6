// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facet rule, leaf by leaf: what is left of the facets of a block. docs/cda.md, "The facet
// rule".
#pragma once

#include "polytope/filtered_polygon.h"
#include "surface/outlines.h"
#include "tree/block_tree.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// What all blocks have in common.
struct EvaluationInput {
    std::span<const Plane> stock;
    /// If not null: the surface of what these have in common with the part, instead of that of the
    /// part.
    const std::vector<Plane>* window = nullptr;
    const CellTable& cells;
    Vec3 centre;  ///< Volumes are summed about it, in lattice units: best near the middle.
    bool only_first = false;  ///< Stop at the first piece of surface.
};

/// What came out of a block.
struct Evaluation {
    Outlines outlines;
    double volume = 0.0;  ///< Cubic lattice units; of a block by itself no volume, only summed up.
    std::uint64_t leaves = 0, facets_tested = 0, facets_alive = 0;
};

/// O(leaves · (planes of a leaf)²).
Evaluation evaluate(const BlockTree& block, const EvaluationInput& input);

}  // namespace ncsim::cda
