// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of a profile by a stack of rings: multiples of the polygons of a family at integer
// heights, as cheap as the tolerance allows.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "polytope/ring_polygon.h"
#include "polytope/strip_costs.h"

#include <limits>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

/// Rings of a polytope, with its cost and error.
struct RingStack {
    std::vector<Ring> rings;  ///< from below upwards
    /// Number of facets of the strips between the rings. Circumscribed and fair stacks also pay for
    /// edges whose directions are not short, and for edges at gentle slopes, because finished parts
    /// consist of copies of these edges.
    double cost = 0.0;
    int corners = 0;
    double error = 0.0;  ///< Bound on the distance between both surfaces, in lattice units.
};

/// Largest depth of facets within the tool, and largest distance of corners outside, around rounded
/// corners, in lattice units. Circumscribed: {0, tolerance}; inscribed: {tolerance, 0}.
struct ToleranceBand {
    double inside = 0.0, outside = 0.0;
};

/// Limits of the search for a stack.
struct StackLimits {
    int corners = 0;
    double cost = std::numeric_limits<double>::infinity();
    /// Rings whose polygons the stack must have, in this order; null: any polygons. A search with a
    /// pattern takes a tenth of the time.
    const std::vector<Ring>* pattern = nullptr;
    bool turns = false;  ///< The tool turns (ToolAccuracy), so that no edge keeps its direction.
};

/// Returns the cheapest stack of rings found that keeps to `band` on rounded corners of the
/// profile. Empty if no such stack is within `limits`. Rings at corners without rounding, and
/// upright parts, use the finest polygon and have its error. Deterministic.
///
/// Cost: O(rings · (polygons · choices)²), where choices are few.
std::optional<RingStack> ring_stack(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                                    Side side, double unit_mm, const ToleranceBand& band,
                                    const StackLimits& limits);

}  // namespace ncsim::toolpath
