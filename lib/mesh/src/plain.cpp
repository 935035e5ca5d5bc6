// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests on vertices and faces come first because most boundaries fail them. Triangles are made only
// for boundaries that pass.
#include "plain.h"

#include "ncsim/cda/triangulate.h"

#include "half_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::mesh {

namespace {

using LoopOfVertices = std::vector<std::uint32_t>;

// Returns the normal times twice the area inside the loop, summed as in merge_groups().
Vec3 loop_area_vector(const std::vector<Vec3>& vertices, const LoopOfVertices& loop) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        sum = sum + cross(vertices[loop[i]] - vertices[loop[0]],
                          vertices[loop[i + 1]] - vertices[loop[0]]);
    }
    return sum;
}

// True if each vertex has at least three loops, all of different faces. Then no vertex is in
// the middle of a chain between two faces, and no loop meets itself or another loop of its face.
bool are_all_corners(const cda::Boundary& boundary) {
    constexpr std::uint32_t kNoFace = ~std::uint32_t{0};
    std::vector<std::uint32_t> loops_at(boundary.vertices.size(), 0);
    std::vector<std::uint32_t> last_face(boundary.vertices.size(), kNoFace);
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        for (const auto& loop : boundary.faces[f].loops) {
            for (const std::uint32_t v : loop) {
                if (std::exchange(last_face[v], f) == f) return false;
                ++loops_at[v];
            }
        }
    }
    return std::ranges::none_of(loops_at, [](std::uint32_t n) { return n < 3; });
}

double largest_distance(const std::vector<Vec3>& vertices, const cda::BoundaryFace& of,
                        const cda::BoundaryFace& plane) {
    double farthest = 0.0;
    for (const auto& loop : of.loops) {
        for (const std::uint32_t v : loop)
            farthest = std::max(farthest, std::abs(dot(plane.normal, vertices[v]) - plane.offset));
    }
    return farthest;
}

// True if simplify_any() might join two faces that share an edge.
bool any_are_joinable(const cda::Boundary& boundary, double share, const Provenance* lines) {
    const std::vector<HalfEdge> edges = half_edges(boundary);
    const std::vector<std::uint32_t> twins = twins_of(edges);
    const auto place_of = [&](const cda::BoundaryFace& face) {
        return lines ? lines->of(face.origin).place() : 0;
    };
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        if (twins[e] < e) continue;
        const cda::BoundaryFace& f = boundary.faces[edges[e].face];
        const cda::BoundaryFace& g = boundary.faces[edges[twins[e]].face];
        if (&f == &g) return true;
        if (dot(f.normal, g.normal) < kMinNormalCosine || place_of(f) != place_of(g)) continue;
        if (f.normal == g.normal || largest_distance(boundary.vertices, f, g) <= share ||
            largest_distance(boundary.vertices, g, f) <= share)
            return true;
    }
    return false;
}

// Puts the loops into the order in which merge_groups() walks them. Returns false if the outline is
// not the first loop, or if there are several outlines.
// Requires: no vertex is in two loops.
bool order_loops(const std::vector<Vec3>& vertices, cda::BoundaryFace& face) {
    for (LoopOfVertices& loop : face.loops)
        std::rotate(loop.begin(), std::ranges::min_element(loop), loop.end());
    std::ranges::sort(face.loops, {}, [](const LoopOfVertices& loop) { return loop.front(); });
    const auto is_outline = [&](const LoopOfVertices& loop) {
        return dot(loop_area_vector(vertices, loop), face.normal) > 0.0;
    };
    const auto holes = std::stable_partition(face.loops.begin(), face.loops.end(), is_outline);
    return holes == face.loops.begin() + 1;
}

// True if a triangle may be lower than `share`, so simplify_any() might move it; a conservative
// test.
bool any_is_thin(const TriangleMesh& mesh, double share) {
    return std::ranges::any_of(mesh.triangles, [&](const auto& corners) {
        const Vec3 a = mesh.vertices[corners[0]], b = mesh.vertices[corners[1]];
        const Vec3 c = mesh.vertices[corners[2]];
        const std::array sides{norm(b - a), norm(c - b), norm(a - c)};
        const double longest = std::ranges::max(sides);
        const double area = 0.5 * norm(cross(b - a, c - a));
        return std::ranges::min(sides) < share || area < share * longest ||
               !(area > 0.0 && std::isfinite(area));
    });
}

// True if all vertices of some shell may be near the plane of its largest triangle.
bool any_is_flake(const cda::Boundary& boundary, const TriangleMesh& mesh, double share) {
    struct Largest {
        double area = -1.0;
        std::uint32_t face = 0;
        bool is_flat = true;
    };
    std::vector<Largest> shells(boundary.shells);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        Largest& shell = shells[boundary.faces[mesh.face[t]].shell];
        const double area =
            norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        if (area > shell.area) shell = {area, mesh.face[t], true};
    }
    for (const cda::BoundaryFace& face : boundary.faces) {
        Largest& shell = shells[face.shell];
        const cda::BoundaryFace& plane = boundary.faces[shell.face];
        shell.is_flat =
            shell.is_flat && largest_distance(boundary.vertices, face, plane) <= 2.0 * share;
    }
    return std::ranges::any_of(
        shells, [](const Largest& shell) { return shell.area >= 0.0 && shell.is_flat; });
}

}  // namespace

std::optional<Simplified> plain_boundary(const cda::Boundary& boundary, double share_mm,
                                         const Provenance* lines) {
    if (!are_all_corners(boundary) || any_are_joinable(boundary, share_mm, lines))
        return std::nullopt;
    Simplified result{{boundary, {}}, 0.0, {}};
    result.origins.reserve(boundary.faces.size());
    for (cda::BoundaryFace& face : result.boundary.faces) {
        Vec3 area;
        for (const LoopOfVertices& loop : face.loops)
            area = area + loop_area_vector(boundary.vertices, loop);
        if (!order_loops(boundary.vertices, face) || !(dot(area, face.normal) > 0.0) ||
            largest_distance(boundary.vertices, face, face) > share_mm)
            return std::nullopt;
        result.origins.push_back({face.origin});
    }
    result.mesh = cda::triangulate(result.boundary);
    const bool is_plain = result.mesh.vertices.size() == boundary.vertices.size() &&
                          !any_is_thin(result.mesh, share_mm) &&
                          !any_is_flake(result.boundary, result.mesh, share_mm);
    if (!is_plain) return std::nullopt;
    return result;
}

}  // namespace ncsim::mesh
