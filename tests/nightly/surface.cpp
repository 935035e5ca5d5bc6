// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closedness, volume and winding number of surfaces.
#include "nightly/surface.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace ncsim::nightly {

bool is_closed(const Surface& surface) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& loop : surface.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            edges.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return edge.first != edge.second &&
               std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
    });
}

double enclosed_volume(const Surface& surface) {
    if (surface.vertices.empty()) return 0.0;
    // Relative to a vertex, to reduce cancellation.
    const Vec origin = surface.vertices.front();
    double sum = 0.0;
    for (const auto& loop : surface.loops) {
        const Vec a = surface.vertices[loop.front()] - origin;
        for (std::size_t i = 2; i < loop.size(); ++i) {
            const Vec b = surface.vertices[loop[i - 1]] - origin;
            const Vec c = surface.vertices[loop[i]] - origin;
            sum += dot(a, cross(b, c));
        }
    }
    return sum / 6;
}

double winding_number(const Surface& triangles, const Vec& p) {
    double sum = 0.0;
    for (const auto& loop : triangles.loops) {
        const Vec a = triangles.vertices[loop[0]] - p;
        const Vec b = triangles.vertices[loop[1]] - p;
        const Vec c = triangles.vertices[loop[2]] - p;
        const double la = norm(a), lb = norm(b), lc = norm(c);
        const double above = dot(a, cross(b, c));
        const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        sum += 2 * std::atan2(above, below);
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace ncsim::nightly
