// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_edges.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ncsim::exporter {

std::vector<HalfEdge> half_edges(const cda::Boundary& boundary) {
    std::vector<HalfEdge> edges;
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        for (const auto& loop : boundary.faces[f].loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                edges.push_back({loop[i], loop[(i + 1) % loop.size()], f});
            }
        }
    }
    return edges;
}

std::vector<std::uint32_t> twins_of(const std::vector<HalfEdge>& edges) {
    std::vector<std::uint32_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t e) {
        const auto& [from, to, face] = edges[e];
        return std::array{std::min(from, to), std::max(from, to), from < to ? 0U : 1U};
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    // A closed surface: they stand in pairs.
    std::vector<std::uint32_t> twins(edges.size());
    for (std::size_t i = 0; i + 1 < order.size(); i += 2) {
        twins[order[i]] = order[i + 1];
        twins[order[i + 1]] = order[i];
    }
    return twins;
}

}  // namespace ncsim::exporter
