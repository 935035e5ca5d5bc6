// SPDX-License-Identifier: GPL-3.0-or-later
//
// A profile becomes a stack of rings: multiples of the polygons of one family at integer heights,
// with as few facets between them as a tolerance allows.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "polytope/ring_polygon.h"

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

/// How far facets around rounded corners may lie within the tool, and corners stand out of it, in
/// lattice units. Circumscribed: {0, tolerance}; inscribed: {tolerance, 0}.
struct Play {
    double within = 0.0, beyond = 0.0;
};

/// The stack of rings with the fewest facets that keeps to `play` on rounded corners of the
/// profile, where there is one of no more corners than `most_corners`. Rings at corners that are
/// not rounded are of the finest polygon, and have the error that they have; so has what is
/// upright. Deterministic. O(rings · (polygons · choices)²), where choices are few.
std::optional<RingStack> ring_stack(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                                    Side side, double unit_mm, const Play& play, int most_corners);

/// How much farther than the round tool the polytope reaches, in lattice units, on average over the
/// lower sides of rounded corners, weighted by the fourth power of the normal's cosine against the
/// axis: gentle slopes are what such tools finish. Averages of a grid of normals. O(rings).
double mean_excess(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                   const std::vector<Ring>& rings, double unit_mm);

}  // namespace ncsim::toolpath
