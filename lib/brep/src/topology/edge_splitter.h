// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that are split at a new vertex.
#pragma once

#include "ncsim/brep/divided_edge.h"
#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Returns the halves of `edge`. Circles and ellipses are split at the fraction `at` of their
/// angle, splines at the middle knot. No value for lines, and for splines without an inner knot.
std::optional<EdgeHalves> split_edge(const Part& part, const Edge& edge, double at = 0.5);

/// Splits edges of a part in all loops together. The loops stay unchanged until finish(). New
/// vertices and edges are appended.
class EdgeSplitter {
public:
    explicit EdgeSplitter(Part& part);
    /// Splits the edge at `at`. False if the edge cannot be split, has been split, or is a new
    /// half.
    bool halve(std::uint32_t edge, double at = 0.5);
    /// Does the same, but splits splines at any place with a new knot.
    bool divide(std::uint32_t edge, double at);
    /// Replaces split edges by their halves in all loops. Cost: O(n) for n edges.
    void finish();

private:
    bool replace(std::uint32_t edge, std::optional<EdgeHalves> halves);

    Part& part_;
    std::vector<std::uint32_t> second_;  // Second half of each original edge, or kNone.
};

}  // namespace ncsim::brep
