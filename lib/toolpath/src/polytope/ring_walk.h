// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of a profile by a stack of rings: multiples of the polygons of a family at integer
// heights, with as few facets between them as the tolerance allows.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "polytope/ring_polygon.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

/// A horizontal section of the polytope.
struct Ring {
    std::size_t polygon = 0;  ///< index in the family
    std::int64_t scale = 0;   ///< multiple of the polygon; 0 for a tip
    std::int64_t height = 0;
};

/// Rings of a polytope, with its cost and error.
struct RingStack {
    std::vector<Ring> rings;  ///< from below upwards
    int facets = 0;           ///< Number of facets of the strips between the rings.
    int corners = 0;
    double error = 0.0;  ///< Bound on the distance between both surfaces, in lattice units.
};

/// Largest depth of facets within the tool, and largest distance of corners outside, around rounded
/// corners, in lattice units. Circumscribed: {0, tolerance}; inscribed: {tolerance, 0}.
struct ToleranceBand {
    double inside = 0.0, outside = 0.0;
};

/// Returns the stack of rings with the fewest facets that keeps to `band` on rounded corners of the
/// profile. Empty if no such stack has at most `most_corners` corners. Rings at corners without
/// rounding, and upright parts, use the finest polygon and have its error. Deterministic.
///
/// Cost: O(rings · (polygons · choices)²), where choices are few.
std::optional<RingStack> ring_stack(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                                    Side side, double unit_mm, const ToleranceBand& band,
                                    int most_corners);

/// Returns how much farther the polytope reaches than the round tool, in lattice units, on average
/// over the lower sides of rounded corners, weighted by the fourth power of the cosine between
/// normal and axis, because rounded tools finish gentle slopes. The average is taken over a grid of
/// normals. Cost: O(rings).
double mean_excess(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                   const std::vector<Ring>& rings, double unit_mm);

}  // namespace ncsim::toolpath
