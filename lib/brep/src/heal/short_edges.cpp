// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/short_edges.h"

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/brep/frames.h"

#include "topology/face_edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Erases straight edges with equal ends from a planar face, and then empty loops. A face without
// loops gets an empty loop.
void drop_edges_of_no_length(Part& part, Face& face) {
    bool any = false;
    for (Loop& loop : face.loops) {
        any = std::erase_if(loop,
                            [&](const EdgeUse& use) {
                                const Edge& edge = part.edges[use.edge];
                                return edge.from == edge.to && is_straight(edge);
                            }) > 0 ||
              any;
    }
    if (!any) return;
    std::erase_if(face.loops, [](const Loop& loop) { return loop.empty(); });
    if (face.loops.empty()) {
        face.loops.emplace_back();
        return;
    }
    face.frame = frame_for(part, face);
}

}  // namespace

bool collapse_short_edges(Part& part, const std::vector<std::uint32_t>& faces, double least_mm) {
    const std::vector<bool> is_flat = flat_vertices(part);
    std::vector<std::pair<double, std::uint32_t>> low;
    for (const std::uint32_t f : faces) {
        for (const EdgeUse& use : uses_of(part.faces[f])) {
            const Edge& edge = part.edges[use.edge];
            const double length = norm(part.vertices[edge.to] - part.vertices[edge.from]);
            if (length < least_mm && is_flat[edge.from] && is_flat[edge.to])
                low.emplace_back(length, use.edge);
        }
    }
    if (low.empty()) return false;
    std::sort(low.begin(), low.end());
    DisjointSets same(part.vertices.size());
    // Bound of the distance of the merged vertices from the position of the first vertex of each
    // set, mm.
    std::vector<double> radius(part.vertices.size(), 0.0);
    bool any = false;
    for (const auto& [length, e] : low) {
        const std::uint32_t a = same.find(part.edges[e].from), b = same.find(part.edges[e].to);
        if (a == b) continue;
        const double separation = norm(part.vertices[b] - part.vertices[a]);
        const double by_a = std::max(radius[a], separation + radius[b]);
        const double by_b = std::max(radius[b], separation + radius[a]);
        if (std::min(by_a, by_b) > 2.0 * least_mm) continue;
        const Vec3 at = part.vertices[by_a <= by_b ? a : b];
        same.unite(a, b);
        const std::uint32_t first = same.find(a);
        part.vertices[first] = at;
        radius[first] = std::min(by_a, by_b);
        any = true;
    }
    if (!any) return false;
    for (Edge& edge : part.edges) {
        edge.from = same.find(edge.from);
        edge.to = same.find(edge.to);
    }
    for (Face& face : part.faces) {
        if (is_plane(face)) drop_edges_of_no_length(part, face);
    }
    return true;
}

}  // namespace ncsim::brep
