// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplifies a boundary in five steps:
//  1. Faces become triangles; thin triangles are removed (remove_slivers), and so are thin shells.
//  2. Triangles are joined to groups across edges while every vertex of a group is near the plane
//     of its largest face; thin triangles may have any normal.
//  3. Each group becomes a face (merge_groups).
//  4. Chains of vertices between two faces that are nearly straight become straight.
//  5. Faces that are no longer in their plane get a new plane.
// A boundary of which no face would change is recognised first (plain.h).
//
// "Thin" and "near" mean within a quarter of the tolerance. If a comparison of the surfaces shows
// that the sum of the steps exceeds the tolerance, all steps are repeated with half that distance.
// Source: Douglas and Peucker, Algorithms for the reduction of the number of points, 1973 (step 4).
#include "ncsim/mesh/simplify.h"

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/triangulate.h"

#include "deviation.h"
#include "half_edges.h"
#include "merge_faces.h"
#include "plain.h"
#include "slivers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace ncsim::mesh {

namespace {

using Vertex = std::uint32_t;
using Loop = std::vector<Vertex>;

double distance(Vec3 a, Vec3 b) {
    return norm(b - a);
}

// Returns the normal times the area, summed over all loops.
Vec3 area_vector(const std::vector<Vec3>& vertices, const cda::BoundaryFace& face) {
    Vec3 sum;
    const Vec3 apex = vertices[face.loops.front().front()];
    for (const Loop& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            sum =
                sum + cross(vertices[loop[i]] - apex, vertices[loop[(i + 1) % loop.size()]] - apex);
        }
    }
    return 0.5 * sum;
}

// Returns each triangle as a face in the plane of its original face.
cda::Boundary boundary_of(const TriangleMesh& mesh, const cda::Boundary& from) {
    cda::Boundary result;
    result.vertices = mesh.vertices;
    result.shells = from.shells;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const cda::BoundaryFace& face = from.faces[mesh.face[t]];
        const auto& corners = mesh.triangles[t];
        result.faces.push_back({face.normal,
                                face.offset,
                                face.origin,
                                face.shell,
                                {{corners.begin(), corners.end()}}});
    }
    return result;
}

// Removes shells without a significant interior: all vertices lie near the plane of the largest
// face.
void drop_flakes(cda::Boundary& boundary, double tolerance) {
    struct Shell {
        double area = -1.0;
        const cda::BoundaryFace* largest = nullptr;
        bool is_flake = true;
    };
    std::vector<Shell> shells(boundary.shells);
    for (const auto& face : boundary.faces) {
        Shell& shell = shells[face.shell];
        const double area = norm(area_vector(boundary.vertices, face));
        if (area > shell.area) shell.area = area, shell.largest = &face;
    }
    for (const auto& face : boundary.faces) {
        Shell& shell = shells[face.shell];
        for (const Vertex v : face.loops.front()) {
            const double off =
                dot(shell.largest->normal, boundary.vertices[v]) - shell.largest->offset;
            shell.is_flake = shell.is_flake && std::abs(off) < tolerance;
        }
    }
    std::erase_if(boundary.faces, [&](const auto& face) { return shells[face.shell].is_flake; });
}

// Step 2: groups of nearly coplanar faces.
class Flats {
public:
    Flats(cda::Boundary& boundary, double tolerance, const Provenance* lines)
        : boundary_(boundary), tolerance_(tolerance), groups_(boundary.faces.size()) {
        for (const auto& face : boundary.faces) {
            Flat flat;
            const Vec3 area = area_vector(boundary.vertices, face);
            flat.area = norm(area);
            flat.normal = face.normal;
            flat.offset = face.offset;
            flat.origin = face.origin;
            if (lines) flat.place = lines->of(face.origin).place();
            double longest = 0.0;
            for (const Loop& loop : face.loops) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    flat.vertices.push_back(loop[i]);
                    longest =
                        std::max(longest, distance(boundary.vertices[loop[i]],
                                                   boundary.vertices[loop[(i + 1) % loop.size()]]));
                }
            }
            flat.is_thin = flat.area < tolerance * longest;
            flats_.push_back(std::move(flat));
        }
    }

    void run() {
        const std::vector<HalfEdge> edges = half_edges(boundary_);
        const std::vector<std::uint32_t> twins = twins_of(edges);
        struct Candidate {
            int rank;
            double length;
            std::uint32_t face, other;
        };
        std::vector<Candidate> candidates;
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (twins[e] < e) continue;
            const std::uint32_t f = edges[e].face;
            const std::uint32_t g = edges[twins[e]].face;
            if (f == g) continue;
            // Exact planes come first; thin faces, which fit to many planes, come last.
            int rank = 1;
            if (flats_[f].is_thin || flats_[g].is_thin) rank = 2;
            if (boundary_.faces[f].normal == boundary_.faces[g].normal) rank = 0;
            candidates.push_back(
                {rank, distance(boundary_.vertices[edges[e].from], boundary_.vertices[edges[e].to]),
                 f, g});
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) {
                             return a.rank != b.rank ? a.rank < b.rank : a.length > b.length;
                         });
        for (const Candidate& c : candidates)
            join(groups_.find(c.face), groups_.find(c.other), c.rank == 0);
        for (std::uint32_t f = 0; f < flats_.size(); ++f) {
            if (groups_.find(f) != f) continue;
            boundary_.faces[f].normal = flats_[f].normal;
            boundary_.faces[f].offset = flats_[f].offset;
        }
    }

    /// Returns the origin of the largest face in the group of `face`.
    cda::Origin origin(std::uint32_t face) { return flats_[groups_.find(face)].origin; }

    DisjointSets& groups() { return groups_; }

private:
    struct Flat {
        Vec3 normal;
        double offset = 0.0;
        double area = 0.0;
        cda::Origin origin = cda::kStockOrigin;
        std::uint64_t place = 0;  // always 0 if lines are ignored
        bool is_thin = false;
        std::vector<Vertex> vertices;
    };

    void join(std::uint32_t a, std::uint32_t b, bool is_exact) {
        if (a == b) return;
        if (flats_[a].area < flats_[b].area) std::swap(a, b);
        Flat& large = flats_[a];
        Flat& small = flats_[b];
        if (!small.is_thin && large.place != small.place) return;
        if (!small.is_thin && dot(large.normal, small.normal) < kMinNormalCosine) return;
        double farthest = 0.0;
        for (const Vertex v : small.vertices) {
            const double off = dot(large.normal, boundary_.vertices[v]) - large.offset;
            farthest = std::max(farthest, std::abs(off));
        }
        if (farthest > tolerance_ && !is_exact) return;
        Flat both;
        both.normal = large.normal;
        both.offset = large.offset;
        both.area = large.area + small.area;
        both.origin = large.origin;
        both.place = large.place;
        both.is_thin = large.is_thin && small.is_thin;
        both.vertices = std::move(large.vertices);
        both.vertices.insert(both.vertices.end(), small.vertices.begin(), small.vertices.end());
        small.vertices.clear();
        groups_.unite(a, b);
        flats_[groups_.find(a)] = std::move(both);
    }

    cda::Boundary& boundary_;
    double tolerance_;
    DisjointSets groups_;
    std::vector<Flat> flats_;  // for a group: the entry of the first face
};

// Step 4: straightens chains of vertices.
class Straightening {
public:
    Straightening(cda::Boundary& boundary, double tolerance)
        : boundary_(boundary),
          tolerance_(tolerance),
          edges_at_(boundary.vertices.size(), 0),
          is_kept_(boundary.vertices.size(), false),
          is_done_(boundary.vertices.size(), false) {}

    void run() {
        for_each_loop([&](const Loop& loop) {
            for (const Vertex v : loop)
                ++edges_at_[v];
        });
        for (Vertex v = 0; v < edges_at_.size(); ++v)
            is_kept_[v] = edges_at_[v] > 2;
        for_each_loop([&](const Loop& loop) { anchor(loop); });
        // Unchanged edges are collected first, because no chain may become one of them.
        std::vector<Loop> chains;
        for_each_loop([&](const Loop& loop) { split(loop, chains); });
        for (const Loop& chain : chains)
            straighten(chain);
        for (auto& face : boundary_.faces) {
            for (Loop& loop : face.loops) {
                std::erase_if(loop, [&](Vertex v) { return !is_kept_[v]; });
                drop_points(loop);
            }
        }
    }

private:
    // Removes repeated vertices. A chain whose vertices are all within the tolerance of its end may
    // start and end in the same vertex.
    static void drop_points(Loop& loop) {
        loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
        while (loop.size() > 1 && loop.front() == loop.back())
            loop.pop_back();
    }

    template <typename Action>
    void for_each_loop(Action action) {
        for (const auto& face : boundary_.faces) {
            for (const Loop& loop : face.loops)
                action(loop);
        }
    }

    // Keeps two distant vertices of a loop with fewer than two corners.
    void anchor(const Loop& loop) {
        const auto is_kept = [&](Vertex v) { return is_kept_[v]; };
        if (std::count_if(loop.begin(), loop.end(), is_kept) > 1) return;
        const auto corner = std::find_if(loop.begin(), loop.end(), is_kept);
        const Vertex a =
            corner != loop.end() ? *corner : *std::min_element(loop.begin(), loop.end());
        const auto far = [&](Vertex v) {
            return distance(boundary_.vertices[a], boundary_.vertices[v]);
        };
        const Vertex b = *std::max_element(loop.begin(), loop.end(), [&](Vertex v, Vertex w) {
            return std::pair(far(v), v) < std::pair(far(w), w);
        });
        is_kept_[a] = is_kept_[b] = true;
    }

    // Appends the pieces between successive kept vertices, both included, that have further
    // vertices between.
    void split(const Loop& loop, std::vector<Loop>& chains) {
        const auto first =
            std::find_if(loop.begin(), loop.end(), [&](Vertex v) { return is_kept_[v]; });
        const auto start = static_cast<std::size_t>(first - loop.begin());
        Loop chain{loop[start]};
        for (std::size_t i = 1; i <= loop.size(); ++i) {
            const Vertex v = loop[(start + i) % loop.size()];
            chain.push_back(v);
            if (!is_kept_[v]) continue;
            if (chain.size() == 2) {
                taken_.insert(std::minmax(chain[0], chain[1]));
            } else if (!is_done_[chain[1]]) {
                for (std::size_t k = 1; k + 1 < chain.size(); ++k)
                    is_done_[chain[k]] = true;
                chains.push_back(chain);
            }
            chain = {v};
        }
    }

    void straighten(const Loop& chain) {
        reduce(chain, 0, chain.size() - 1, false);
        const bool is_edge =
            std::none_of(chain.begin() + 1, chain.end() - 1, [&](Vertex v) { return is_kept_[v]; });
        if (!is_edge || taken_.insert(std::minmax(chain.front(), chain.back())).second) return;
        // The edge exists already; the chain keeps a vertex to make the edges different.
        reduce(chain, 0, chain.size() - 1, true);
    }

    void reduce(const Loop& chain, std::size_t first, std::size_t last, bool keeps_one) {
        if (last - first < 2) return;
        std::size_t middle = first + 1;
        double far = -1.0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d =
                distance_to_segment(boundary_.vertices[chain[i]], boundary_.vertices[chain[first]],
                                    boundary_.vertices[chain[last]]);
            if (d > far) far = d, middle = i;
        }
        if (far <= tolerance_ && !keeps_one) return;
        is_kept_[chain[middle]] = true;
        reduce(chain, first, middle, false);
        reduce(chain, middle, last, false);
    }

    cda::Boundary& boundary_;
    double tolerance_;
    std::vector<std::uint32_t> edges_at_;
    std::vector<bool> is_kept_, is_done_;
    std::set<std::pair<Vertex, Vertex>> taken_;
};

double farthest_from_plane(const std::vector<Vec3>& vertices, const cda::BoundaryFace& face) {
    double farthest = 0.0;
    for (const Loop& loop : face.loops) {
        for (const Vertex v : loop) {
            const double off = dot(face.normal, vertices[v]) - face.offset;
            farthest = std::max(farthest, std::abs(off));
        }
    }
    return farthest;
}

// Step 5: sets the plane normal to the area vector, through the middle of the corners.
void fit_plane(const std::vector<Vec3>& vertices, cda::BoundaryFace& face) {
    const Vec3 area = area_vector(vertices, face);
    if (!(norm(area) > 0.0)) return;
    face.normal = normalized(area);
    double least = Box::kInf;
    double most = -Box::kInf;
    for (const Vertex v : face.loops.front()) {
        const double at = dot(face.normal, vertices[v]);
        least = std::min(least, at);
        most = std::max(most, at);
    }
    face.offset = 0.5 * (least + most);
}

// Removes vertices that no face uses; the others keep their order.
void remove_unused_vertices(cda::Boundary& boundary) {
    std::vector<std::uint8_t> is_used(boundary.vertices.size(), 0);
    for (const auto& face : boundary.faces) {
        for (const Loop& loop : face.loops) {
            for (const Vertex v : loop)
                is_used[v] = 1;
        }
    }
    std::vector<Vertex> index(boundary.vertices.size());
    Vertex count = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
        index[v] = count;
        if (is_used[v] != 0) boundary.vertices[count++] = boundary.vertices[v];
    }
    boundary.vertices.resize(count);
    for (auto& face : boundary.faces) {
        for (Loop& loop : face.loops) {
            for (Vertex& v : loop)
                v = index[v];
        }
    }
}

struct Thinned {
    JoinedFaces faces;
    // False if thin triangles were removed, which may add up to more than the tolerance. Groups,
    // chains and new planes are off by at most a share each.
    bool is_near = true;
};

Thinned simplify_steps(const cda::Boundary& boundary, TriangleMesh mesh, double share,
                       const Provenance* lines) {
    const bool is_near = !remove_slivers(mesh, share);
    cda::Boundary work = boundary_of(mesh, boundary);
    drop_flakes(work, share);
    if (work.faces.empty()) return {};
    Flats flats(work, share, lines);
    flats.run();
    MergedFaces merged = merge_groups(work, flats.groups());
    if (lines) {
        for (std::size_t f = 0; f < merged.group.size(); ++f)
            merged.boundary.faces[f].origin = flats.origin(merged.group[f]);
    }
    Straightening(merged.boundary, share).run();
    remove_unused_vertices(merged.boundary);
    for (auto& face : merged.boundary.faces) {
        const bool is_right_way =
            dot(area_vector(merged.boundary.vertices, face), face.normal) > 0.0;
        if (!is_right_way || farthest_from_plane(merged.boundary.vertices, face) > share)
            fit_plane(merged.boundary.vertices, face);
    }
    return {{std::move(merged.boundary), std::move(merged.origins)}, is_near};
}

// Returns `mesh` without the shells that vanished. A flake thinner than the tolerance may vanish
// whatever its width: its points are near empty space, but may be far from the remaining surface.
TriangleMesh remove_lost_shells(TriangleMesh mesh, const cda::Boundary& before,
                                const cda::Boundary& after) {
    std::vector<bool> is_left(before.shells, false);
    for (const auto& face : after.faces)
        is_left[face.shell] = true;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!is_left[before.faces[mesh.face[t]].shell]) continue;
        mesh.triangles[kept] = mesh.triangles[t];
        mesh.face[kept++] = mesh.face[t];
    }
    mesh.triangles.resize(kept);
    mesh.face.resize(kept);
    return mesh;
}

// Without `has_mesh`, the result may have no triangles and no deviation.
Simplified simplify(const cda::Boundary& boundary, double tolerance_mm, const Provenance* lines,
                    bool has_mesh) {
    if (boundary.faces.empty()) return {{boundary, {}}, 0.0, {}};
    if (auto plain = plain_boundary(boundary, 0.25 * tolerance_mm, lines)) return std::move(*plain);
    return simplify_any(boundary, tolerance_mm, lines, has_mesh);
}

}  // namespace

Simplified simplify(const cda::Boundary& boundary, double tolerance_mm, const Provenance* lines) {
    return simplify(boundary, tolerance_mm, lines, true);
}

JoinedFaces join_faces(const cda::Boundary& boundary, double tolerance_mm,
                       const Provenance* lines) {
    Simplified faces = simplify(boundary, tolerance_mm, lines, false);
    return {std::move(faces.boundary), std::move(faces.origins)};
}

Simplified simplify_any(const cda::Boundary& boundary, double tolerance_mm, const Provenance* lines,
                        bool has_mesh) {
    const TriangleMesh before = cda::triangulate(boundary);
    for (double share = 0.25 * tolerance_mm;; share *= 0.5) {
        // Far below the tolerance, only rounding is left to move.
        if (share < 1e-3 * tolerance_mm) share = 0.0;
        Thinned thinned = simplify_steps(boundary, before, share, lines);
        Simplified result{std::move(thinned.faces), 0.0, {}};
        // The part is smaller than the tolerance.
        if (result.boundary.faces.empty() || (thinned.is_near && !has_mesh)) return result;
        result.mesh = cda::triangulate(result.boundary);
        result.deviation_mm =
            deviation(remove_lost_shells(before, boundary, result.boundary), result.mesh);
        if (result.deviation_mm <= tolerance_mm || share == 0.0) return result;
    }
}

}  // namespace ncsim::mesh
