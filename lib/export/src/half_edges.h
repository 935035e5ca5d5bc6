// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of a closed surface, each from both sides; and faces in groups.
#pragma once

#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <vector>

namespace ncsim::exporter {

struct HalfEdge {
    std::uint32_t from, to;  ///< Vertices.
    std::uint32_t face;      ///< On its left.
};

/// Of all loops, in their order.
std::vector<HalfEdge> half_edges(const cda::Boundary& boundary);

/// For each half-edge, by position, the one in the other direction. Requires a closed surface.
/// O(n log n).
std::vector<std::uint32_t> twins_of(const std::vector<HalfEdge>& edges);

/// Disjoint sets of numbers; the smallest number of each stands for it.
class Groups {
public:
    explicit Groups(std::size_t count);
    std::uint32_t find(std::uint32_t i);
    void join(std::uint32_t a, std::uint32_t b);

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace ncsim::exporter
