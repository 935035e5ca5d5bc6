// SPDX-License-Identifier: GPL-3.0-or-later
//
// A profile becomes a stack of rings: multiples of the polygons of one family at integer heights,
// with as few facets between them as a tolerance allows.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "ring_polygon.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

struct Ring {
    std::size_t polygon = 0;  ///< of the family
    std::int64_t scale = 0;   ///< 0: a tip
    std::int64_t height = 0;
};

struct RingStack {
    std::vector<Ring> rings;  ///< upwards
    int facets = 0;           ///< Of the strips between them.
    int corners = 0;
    double error = 0.0;  ///< In lattice units: bound on the distance between both surfaces.
};

/// The stack of rings with the fewest facets whose error on rounded corners of the profile is at
/// most `tolerance` (lattice units), where there is one of no more corners than `most_corners`.
/// Rings at corners that are not rounded are of the finest polygon, and have the error that they
/// have; so has what is upright. Deterministic. O(rings · (polygons · choices)²), where choices are
/// few.
std::optional<RingStack> ring_stack(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                                    Side side, double unit_mm, double tolerance, int most_corners);

}  // namespace ncsim::toolpath
