// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges faces in two steps:
//  1. Remove the edges with the same group on both sides; the remaining edges of a group are its
//     outlines.
//  2. Walk the outlines with the interior on the left. If outlines touch in a vertex, continue
//     along the first edge counter-clockwise from the incoming edge; the sector between the two
//     edges is outside. So each loop goes around one connected piece of the outside and passes no
//     vertex twice: otherwise the group would be connected at that vertex only.
#include "merge_faces.h"

#include "half_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ncsim::mesh {

namespace {

using VertexIndex = std::uint32_t;

// Returns a number from 0 to 4 that grows with the angle from `back` to `out`, counter-clockwise
// about `normal`. Comparison of angles needs no arctangent.
double counterclockwise_turn(Vec3 back, Vec3 out, Vec3 normal) {
    const double x = dot(back, out);
    const double y = dot(cross(back, out), normal);
    const double length = std::abs(x) + std::abs(y);
    if (length == 0.0) return 4.0;
    const double quarter = x / length;  // 1 … -1 over the first half turn
    return y >= 0.0 ? 1.0 - quarter : 3.0 + quarter;
}

double signed_area(const std::vector<Vec3>& vertices, const std::vector<VertexIndex>& loop,
                   Vec3 normal) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        sum = sum + cross(vertices[loop[i]] - vertices[loop[0]],
                          vertices[loop[i + 1]] - vertices[loop[0]]);
    }
    return dot(sum, normal);
}

// Step 2 for a group with the remaining `edges`, sorted by their start.
std::vector<std::vector<VertexIndex>> walk(const std::vector<Vec3>& vertices,
                                           const std::vector<HalfEdge>& edges, Vec3 normal) {
    std::vector<bool> is_used(edges.size(), false);
    std::vector<std::vector<VertexIndex>> loops;
    const auto next_of = [&](const HalfEdge& edge) {
        const auto first =
            std::lower_bound(edges.begin(), edges.end(), edge.to,
                             [](const HalfEdge& e, VertexIndex vertex) { return e.from < vertex; });
        const Vec3 back = vertices[edge.from] - vertices[edge.to];
        auto best = first;
        double least = 5.0;
        for (auto e = first; e != edges.end() && e->from == edge.to; ++e) {
            const double turn =
                counterclockwise_turn(back, vertices[e->to] - vertices[e->from], normal);
            if (turn < least && !is_used[static_cast<std::size_t>(e - edges.begin())]) {
                least = turn;
                best = e;
            }
        }
        return static_cast<std::size_t>(best - edges.begin());
    };
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (is_used[start]) continue;
        std::vector<VertexIndex> loop;
        std::size_t e = start;
        while (e < edges.size() && !is_used[e]) {
            is_used[e] = true;
            loop.push_back(edges[e].from);
            e = next_of(edges[e]);
        }
        loops.push_back(std::move(loop));
    }
    // Moves the outline, which is the counter-clockwise loop, to the front.
    std::stable_partition(loops.begin(), loops.end(), [&](const auto& loop) {
        return signed_area(vertices, loop, normal) > 0.0;
    });
    return loops;
}

}  // namespace

MergedFaces merge_groups(const cda::Boundary& boundary, DisjointSets& groups) {
    const std::vector<HalfEdge> edges = half_edges(boundary);
    const std::vector<std::uint32_t> twins = twins_of(edges);
    // Remaining edges of each group, by the number of the group's first face.
    std::vector<std::vector<HalfEdge>> outlines(boundary.faces.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const std::uint32_t group = groups.find(edges[e].face);
        if (group != groups.find(edges[twins[e]].face)) outlines[group].push_back(edges[e]);
    }
    std::vector<std::vector<cda::Origin>> origins(boundary.faces.size());
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        origins[groups.find(f)].push_back(boundary.faces[f].origin);
    }

    MergedFaces result;
    result.boundary.vertices = boundary.vertices;
    result.boundary.shells = boundary.shells;
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        // A group without an outline is a whole shell: both sides of a flake.
        if (groups.find(f) != f || outlines[f].empty()) continue;
        std::stable_sort(outlines[f].begin(), outlines[f].end(),
                         [](const HalfEdge& a, const HalfEdge& b) { return a.from < b.from; });
        std::sort(origins[f].begin(), origins[f].end());
        origins[f].erase(std::unique(origins[f].begin(), origins[f].end()), origins[f].end());
        cda::BoundaryFace face = boundary.faces[f];
        face.origin = origins[f].front();
        face.loops = walk(boundary.vertices, outlines[f], face.normal);
        result.boundary.faces.push_back(std::move(face));
        result.group.push_back(f);
        result.origins.push_back(std::move(origins[f]));
    }
    return result;
}

}  // namespace ncsim::mesh
