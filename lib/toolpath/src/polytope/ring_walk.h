// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of a profile by a stack of rings: multiples of the polygons of a family at integer
// heights, as cheap as the tolerance allows.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "polytope/ring_polygon.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

/// Largest length of a short edge direction, in units, after division by the common factor of its
/// components. The walls of a tool that moves by t have normals e × t for edge directions e. If |e|
/// |t| < 2^24 (cda::kNormalBits), these normals are exact, and the walls of successive moves meet
/// in the edge. Rounded normals leave slivers of nanometres along each edge. 1,400 suffices for
/// moves up to 12 mm with three decimals.
inline constexpr double kShortDirection = 1400.0;

/// A horizontal section of the polytope.
struct Ring {
    std::size_t polygon = 0;  ///< index in the family
    std::int64_t scale = 0;   ///< multiple of the polygon; 0 for a tip
    std::int64_t height = 0;
};

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

/// Returns how much farther the polytope reaches than the round tool, in lattice units, on average
/// over the lower sides of rounded corners, weighted by the fourth power of the cosine between
/// normal and axis, because rounded tools finish gentle slopes. The average is taken over a grid of
/// normals. Cost: O(rings).
double mean_excess(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                   const std::vector<Ring>& rings, double unit_mm);

}  // namespace ncsim::toolpath
