// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts of directed edges without partners.
#include "ncsim/mesh/seams.h"

#include "ncsim/base/mix.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace ncsim::mesh {

std::size_t Seams::Hash::operator()(const FloatEdge& edge) const {
    std::uint64_t h = 0;
    for (const auto& corner : edge) {
        for (const float x : corner)
            h = mix(h, std::bit_cast<std::uint32_t>(x));
    }
    return h;
}

void Seams::add(const FloatEdge& edge) {
    // An edge of zero length is invisible to readers.
    if (edge[0] == edge[1]) return;
    const bool is_turned = edge[1] < edge[0];
    const FloatEdge key = is_turned ? FloatEdge{edge[1], edge[0]} : edge;
    const auto [found, is_new] = net_.try_emplace(key, 0);
    int& net = found->second;
    open_ -= static_cast<std::size_t>(std::abs(net));
    net += is_turned ? -1 : 1;
    open_ += static_cast<std::size_t>(std::abs(net));
    if (net == 0) net_.erase(found);
}

void Seams::add(std::span<const FloatEdge> edges) {
    for (const FloatEdge& edge : edges)
        add(edge);
}

std::vector<FloatEdge> Seams::edges() const {
    std::vector<FloatEdge> all;
    for (const auto& [edge, net] : net_)
        all.insert(all.end(), static_cast<std::size_t>(std::abs(net)),
                   net > 0 ? edge : FloatEdge{edge[1], edge[0]});
    std::ranges::sort(all);
    return all;
}

}  // namespace ncsim::mesh
