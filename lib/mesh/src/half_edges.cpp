// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges of a boundary and their twins.
#include "half_edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ncsim::mesh {

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
    // Sorts the half-edges by their lower end, then by their upper end.
    const auto lower = [&](std::uint32_t e) { return std::min(edges[e].from, edges[e].to); };
    std::vector<std::uint32_t> first;  // in order, for each lower end
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        if (first.size() < lower(e) + std::size_t{2}) first.resize(lower(e) + std::size_t{2}, 0);
        ++first[lower(e) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> next(first), order(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        order[next[lower(e)]++] = e;
    const auto key = [&](std::uint32_t e) {
        const auto& [from, to, face] = edges[e];
        return std::pair{std::max(from, to), from < to ? 0U : 1U};
    };
    for (std::size_t v = 0; v + 1 < first.size(); ++v) {
        std::sort(order.begin() + first[v], order.begin() + first[v + 1],
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    }
    // The surface is closed, so half-edges come in pairs.
    std::vector<std::uint32_t> twins(edges.size());
    for (std::size_t i = 0; i + 1 < order.size(); i += 2) {
        twins[order[i]] = order[i + 1];
        twins[order[i + 1]] = order[i];
    }
    return twins;
}

}  // namespace ncsim::mesh
