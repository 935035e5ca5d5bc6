// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces to triangles. The usual face goes through CGAL's constrained Delaunay triangulation,
// whose triangles are as round as the corners allow. Where rounding to doubles has made edges of
// a face cross or corners coincide, ears are cut instead: that works on the loops alone, so
// the mesh stays closed whatever the coordinates are.
#include "ncsim/cda/mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ncsim::cda {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Point2 = Kernel::Point_2;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Seen along the longest axis of the normal, so that counter-clockwise stays so.
struct Projection {
    int first = 0, second = 1;

    explicit Projection(Vec3 n) {
        int dropped = 2;
        if (std::abs(n.x) >= std::abs(n.y) && std::abs(n.x) >= std::abs(n.z)) {
            dropped = 0;
        } else if (std::abs(n.y) >= std::abs(n.z)) {
            dropped = 1;
        }
        first = (dropped + 1) % 3;
        second = (dropped + 2) % 3;
        if (n[dropped] < 0.0) std::swap(first, second);
    }
    Point2 operator()(Vec3 p) const { return {p[first], p[second]}; }
};

// Nothing where a corner stands twice, edges cross or a corner lies on an edge.
std::optional<std::vector<Triangle>> delaunay(const Boundary& boundary, const BoundaryFace& face) {
    const Projection view(face.normal);
    Delaunay cdt;
    std::map<std::uint32_t, Delaunay::Vertex_handle> handles;
    std::size_t corners = 0;
    for (const auto& loop : face.loops) {
        for (const std::uint32_t v : loop) {
            const auto handle = cdt.insert(view(boundary.vertices[v]));
            handle->info() = v;
            handles[v] = handle;
            ++corners;
        }
    }
    if (handles.size() != corners || cdt.number_of_vertices() != corners) return std::nullopt;
    try {
        for (const auto& loop : face.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                cdt.insert_constraint(handles[loop[i]], handles[loop[(i + 1) % loop.size()]]);
            }
        }
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
        return std::nullopt;
    }
    for (const auto& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (!cdt.is_edge(handles[loop[i]], handles[loop[(i + 1) % loop.size()]])) {
                return std::nullopt;
            }
        }
    }
    // Levels of nesting from outside: the face is where their number is odd.
    for (auto f : cdt.all_face_handles())
        f->info() = -1;
    std::deque<Delaunay::Face_handle> queue{cdt.infinite_face()};
    cdt.infinite_face()->info() = 0;
    while (!queue.empty()) {
        const auto f = queue.front();
        queue.pop_front();
        for (int i = 0; i < 3; ++i) {
            const auto n = f->neighbor(i);
            if (n->info() >= 0) continue;
            const bool crosses = f->is_constrained(i);
            n->info() = f->info() + (crosses ? 1 : 0);
            // Faces of one level first.
            crosses ? queue.push_back(n) : queue.push_front(n);
        }
    }
    std::vector<Triangle> triangles;
    for (auto f : cdt.finite_face_handles()) {
        if (f->info() % 2 == 0) continue;
        triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
    if (triangles.size() + 2 != corners + 2 * (face.loops.size() - 1)) return std::nullopt;
    return triangles;
}

double doubled_area(Point2 a, Point2 b, Point2 c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Joins the holes to the outline by their nearest corners, then cuts ears: a corner without others
// in its triangle where there is one, the best of all otherwise. Always n − 2 triangles.
std::vector<Triangle> cut_ears(const Boundary& boundary, const BoundaryFace& face) {
    const Projection view(face.normal);
    const auto at = [&](std::uint32_t v) { return view(boundary.vertices[v]); };
    std::vector<std::uint32_t> ring = face.loops[0];
    for (std::size_t h = 1; h < face.loops.size(); ++h) {
        const auto& hole = face.loops[h];
        std::size_t best_i = 0;
        std::size_t best_k = 0;
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            for (std::size_t k = 0; k < hole.size(); ++k) {
                const double d = CGAL::squared_distance(at(ring[i]), at(hole[k]));
                if (d < best) best = d, best_i = i, best_k = k;
            }
        }
        std::vector<std::uint32_t> bridge;
        for (std::size_t k = 0; k <= hole.size(); ++k) {
            bridge.push_back(hole[(best_k + k) % hole.size()]);
        }
        bridge.push_back(ring[best_i]);
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(best_i) + 1, bridge.begin(),
                    bridge.end());
    }
    std::vector<Triangle> triangles;
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        std::size_t best = kNone;
        double best_area = -std::numeric_limits<double>::infinity();
        bool best_is_free = false;
        for (std::size_t i = 0; i < n; ++i) {
            const Point2 a = at(ring[(i + n - 1) % n]);
            const Point2 b = at(ring[i]);
            const Point2 c = at(ring[(i + 1) % n]);
            const double size = doubled_area(a, b, c);
            const bool is_free = size > 0.0 && std::none_of(ring.begin(), ring.end(), [&](auto v) {
                                     const Point2 p = at(v);
                                     if (p == a || p == b || p == c) return false;
                                     return doubled_area(a, b, p) >= 0.0 &&
                                            doubled_area(b, c, p) >= 0.0 &&
                                            doubled_area(c, a, p) >= 0.0;
                                 });
            if (std::pair{is_free, size} > std::pair{best_is_free, best_area} || best == kNone) {
                best = i, best_area = size, best_is_free = is_free;
            }
        }
        triangles.push_back({ring[(best + n - 1) % n], ring[best], ring[(best + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
}

// Two faces that share two corners may both have the diagonal between them, or one has as a
// diagonal what is an edge of another: where corners lie on one line but for rounding. Such a
// diagonal gets a corner of its own in the middle, so that no edge stands twice; edges of faces
// stay.
void split_repeated_diagonals(const Boundary& boundary, TriangleMesh& mesh) {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<std::pair<Edge, std::uint32_t>> edges;  // without direction, triangle
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace_back(std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]),
                               t);
        }
    }
    std::sort(edges.begin(), edges.end());
    std::set<std::pair<std::uint32_t, Edge>> outlines;  // of the faces concerned
    std::set<std::uint32_t> known;
    const auto is_outline = [&](std::uint32_t face, Edge edge) {
        if (known.insert(face).second) {
            for (const auto& loop : boundary.faces[face].loops) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    outlines.emplace(face, std::minmax(loop[i], loop[(i + 1) % loop.size()]));
                }
            }
        }
        return outlines.contains({face, edge});
    };
    const auto halve = [&](std::uint32_t t, Edge edge, std::uint32_t middle) {
        // (a, b, c) with the edge a → b: (a, m, c) and (m, b, c).
        const Triangle old = mesh.triangles[t];
        std::size_t i = 0;
        while (std::minmax(old[i], old[(i + 1) % 3]) != std::minmax(edge.first, edge.second))
            ++i;
        mesh.triangles[t] = {old[i], middle, old[(i + 2) % 3]};
        mesh.triangles.push_back({middle, old[(i + 1) % 3], old[(i + 2) % 3]});
        mesh.face.push_back(mesh.face[t]);
        return static_cast<std::uint32_t>(mesh.triangles.size() - 1);
    };
    // A triangle that was halved is found by what it was: its parts, by number.
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
    const auto holder = [&](std::uint32_t t, Edge edge) {
        std::vector<std::uint32_t> open{t};
        while (!open.empty()) {
            const std::uint32_t now = open.back();
            open.pop_back();
            const Triangle& corners = mesh.triangles[now];
            for (std::size_t i = 0; i < 3; ++i) {
                if (Edge(std::minmax(corners[i], corners[(i + 1) % 3])) == edge) return now;
            }
            if (const auto it = parts.find(now); it != parts.end()) {
                open.insert(open.end(), it->second.begin(), it->second.end());
            }
        }
        return t;
    };
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin;
        while (end < edges.size() && edges[end].first == edges[begin].first)
            ++end;
        const Edge edge = edges[begin].first;
        if (end - begin > 2) {
            std::map<std::uint32_t, std::vector<std::uint32_t>> by_face;
            for (std::size_t i = begin; i < end; ++i) {
                by_face[mesh.face[edges[i].second]].push_back(edges[i].second);
            }
            for (const auto& [face, triangles] : by_face) {
                if (triangles.size() < 2 || is_outline(face, edge)) continue;
                const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(0.5 *
                                        (mesh.vertices[edge.first] + mesh.vertices[edge.second]));
                for (const std::uint32_t t : triangles) {
                    const std::uint32_t now = holder(t, edge);
                    parts[now].push_back(halve(now, edge, middle));
                }
            }
        }
        begin = end;
    }
}

}  // namespace

TriangleMesh triangulate(const Boundary& boundary) {
    TriangleMesh mesh;
    mesh.vertices = boundary.vertices;
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        const BoundaryFace& face = boundary.faces[f];
        std::vector<Triangle> triangles;
        if (face.loops.size() == 1 && face.loops[0].size() == 3) {
            triangles.push_back({face.loops[0][0], face.loops[0][1], face.loops[0][2]});
        } else if (auto round = delaunay(boundary, face)) {
            triangles = std::move(*round);
        } else {
            triangles = cut_ears(boundary, face);
        }
        mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
        mesh.face.insert(mesh.face.end(), triangles.size(), f);
    }
    split_repeated_diagonals(boundary, mesh);
    return mesh;
}

}  // namespace ncsim::cda
