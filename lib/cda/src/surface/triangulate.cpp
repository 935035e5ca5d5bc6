// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulation of faces with triangles as round as the corners allow: convex faces with few
// corners directly, all others by CGAL's constrained Delaunay triangulation. If rounding to doubles
// has made edges of a face cross or corners coincide, edges are first divided at their crossings
// (Chains).
#include "ncsim/cda/triangulate.h"

#include "ncsim/base/parallel.h"
#include "ncsim/base/triangle_mesh.h"

#include "exact/none.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace ncsim::cda {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Corner {
    std::uint32_t vertex = kNone;
    std::uint32_t next = kNone;  // for faces without repeated corners: the following corner
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Crossing = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>>;
using Point2 = Kernel::Point_2;
using Triangle = std::array<std::uint32_t, 3>;

// Projection along the longest axis of the normal that keeps counter-clockwise loops
// counter-clockwise.
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

// Net number of traversals of edges by the loops of a face: forward minus backward.
class EdgeTraversals {
public:
    void add(std::uint32_t from, std::uint32_t to) {
        ++net_[{from, to}];
        --net_[{to, from}];
    }
    int net(std::uint32_t from, std::uint32_t to) const {
        const auto found = net_.find({from, to});
        return found == net_.end() ? 0 : found->second;
    }
    bool cancel() const {
        return std::all_of(net_.begin(), net_.end(), [](const auto& e) { return e.second == 0; });
    }

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> net_;
};

// Stores in each triangle the winding number of the path. `net(from, to)` is the net number of
// traversals of an edge.
// Requires: all edges of the path are constrained.
template <class Triangulation, class Net>
void propagate_winding(Triangulation& cdt, Net net) {
    constexpr int kUnknown = std::numeric_limits<int>::min();
    for (auto f : cdt.all_face_handles())
        f->info() = kUnknown;
    std::vector<typename Triangulation::Face_handle> open{cdt.infinite_face()};
    open.front()->info() = 0;
    while (!open.empty()) {
        const auto f = open.back();
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto next = f->neighbor(i);
            if (next->info() != kUnknown) continue;
            next->info() = f->info();
            if (f->is_constrained(i)) {
                next->info() -= net(f->vertex(Triangulation::ccw(i))->info(),
                                    f->vertex(Triangulation::cw(i))->info());
            }
            open.push_back(next);
        }
    }
}

// Appends each triangle as often as its winding number, reversed if the number is negative.
template <class Triangulation>
void append_by_winding(const Triangulation& cdt, std::vector<Triangle>& triangles) {
    for (const auto f : cdt.finite_face_handles()) {
        Triangle t{f->vertex(0)->info().vertex, f->vertex(1)->info().vertex,
                   f->vertex(2)->info().vertex};
        if (f->info() < 0) std::swap(t[1], t[2]);
        triangles.insert(triangles.end(), static_cast<std::size_t>(std::abs(f->info())), t);
    }
}

// Returns the constrained Delaunay triangulation; empty if a corner is repeated, edges cross, a
// corner lies on an edge, or the face is not on the left of its loops.
std::optional<std::vector<Triangle>> delaunay(const Boundary& boundary, const BoundaryFace& face) {
    const Projection view(face.normal);
    Delaunay cdt;
    std::vector<Delaunay::Vertex_handle> handles;
    for (const auto& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Delaunay::Face_handle near =
                handles.empty() ? Delaunay::Face_handle() : handles.back()->face();
            handles.push_back(cdt.insert(view(boundary.vertices[loop[i]]), near));
            handles.back()->info() = {loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]};
        }
    }
    const std::size_t corners = handles.size();
    if (cdt.number_of_vertices() != corners) return std::nullopt;
    if (cdt.dimension() < 2) return std::nullopt;
    // Calls edge(from, to) until a call returns false.
    const auto all_edges = [&](auto edge) {
        auto first = handles.begin();
        for (const auto& loop : face.loops) {
            const auto last = first + static_cast<std::ptrdiff_t>(loop.size()) - 1;
            for (auto at = first; at != last; ++at) {
                if (!edge(*at, *std::next(at))) return false;
            }
            if (!edge(*last, *first)) return false;
            first = std::next(last);
        }
        return true;
    };
    using Handle = Delaunay::Vertex_handle;
    try {
        all_edges([&](Handle from, Handle to) {
            cdt.insert_constraint(from, to);
            return true;
        });
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
        return std::nullopt;
    }
    if (!all_edges([&](Handle from, Handle to) { return cdt.is_edge(from, to); }))
        return std::nullopt;
    propagate_winding(cdt, [](const Corner& from, const Corner& to) {
        return static_cast<int>(from.next == to.vertex) - static_cast<int>(to.next == from.vertex);
    });
    const auto all = cdt.finite_face_handles();
    if (std::any_of(all.begin(), all.end(),
                    [](const auto f) { return f->info() != 0 && f->info() != 1; }))
        return std::nullopt;
    std::vector<Triangle> triangles;
    append_by_winding(cdt, triangles);
    if (triangles.size() + 2 != corners + 2 * (face.loops.size() - 1)) return std::nullopt;
    return triangles;
}

// The Delaunay triangulation of a face without holes that is convex after rounding; corners may lie
// on edges. Most faces are convex, most of them with four corners. Fails if the face is not convex
// or has many corners.
// Cost: O(corners²).
class ConvexFace {
public:
    ConvexFace(const Boundary& boundary, const BoundaryFace& face) : loop_(face.loops[0]) {
        constexpr std::size_t kMost = 32;
        if (face.loops.size() != 1 || loop_.size() > kMost) return;
        const Projection view(face.normal);
        for (const std::uint32_t v : loop_)
            corners_.push_back(view(boundary.vertices[v]));
    }

    bool append(std::vector<Triangle>& triangles) {
        if (!is_convex()) return false;
        below(0, corners_.size() - 1, triangles);
        return true;
    }

private:
    // True if all corners turn left or are straight, and the loop winds once.
    bool is_convex() const {
        const std::size_t n = corners_.size();
        if (n < 3) return false;
        int maxima = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point2& a = corners_[i];
            const Point2& b = corners_[(i + 1) % n];
            const Point2& c = corners_[(i + 2) % n];
            const CGAL::Orientation turn = CGAL::orientation(a, b, c);
            if (turn == CGAL::RIGHT_TURN) return false;
            if (turn == CGAL::COLLINEAR &&
                !CGAL::collinear_are_strictly_ordered_along_line(a, b, c))
                return false;
            maxima += a < b && c < b ? 1 : 0;
        }
        return maxima == 1;
    }

    // Triangulates the region between the edge from the last to the first corner and the chain from
    // the first to the last. The third corner of the edge's triangle is the corner whose
    // circumcircle with the edge contains no other corner; the first among equals.
    void below(std::size_t first, std::size_t last, std::vector<Triangle>& triangles) {
        if (last - first < 2) return;
        std::size_t third = last;
        for (std::size_t k = first + 1; k < last; ++k) {
            if (CGAL::orientation(corners_[last], corners_[first], corners_[k]) != CGAL::LEFT_TURN)
                continue;
            if (third == last ||
                CGAL::side_of_oriented_circle(corners_[last], corners_[first], corners_[third],
                                              corners_[k]) == CGAL::ON_POSITIVE_SIDE)
                third = k;
        }
        triangles.push_back({loop_[last], loop_[first], loop_[third]});
        below(first, third, triangles);
        below(third, last, triangles);
    }

    const std::vector<std::uint32_t>& loop_;
    std::vector<Point2> corners_;
};

// Drops pairs of triangles with the same corners and opposite orientation: together the two enclose
// no area and traverse each edge in both directions.
void cancel_opposites(std::vector<Triangle>& triangles) {
    struct Seen {
        Triangle corners;  // sorted
        bool is_even;      // true if the triangle is an even permutation of `corners`
        std::uint32_t number;
    };
    std::vector<Seen> seen;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        Triangle t = triangles[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool is_even = t[1] < t[2];
        if (!is_even) std::swap(t[1], t[2]);
        seen.push_back({t, is_even, i});
    }
    std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
        return std::tie(a.corners, a.is_even, a.number) < std::tie(b.corners, b.is_even, b.number);
    });
    std::vector<bool> cancelled(triangles.size(), false);
    for (auto begin = seen.begin(); begin != seen.end();) {
        const auto end = std::find_if(begin, seen.end(),
                                      [&](const Seen& s) { return s.corners != begin->corners; });
        const auto even = std::find_if(begin, end, [](const Seen& s) { return s.is_even; });
        for (std::ptrdiff_t i = 0; i < std::min(even - begin, end - even); ++i)
            cancelled[begin[i].number] = cancelled[even[i].number] = true;
        begin = end;
    }
    std::size_t i = 0;
    std::erase_if(triangles, [&](const Triangle&) { return cancelled[i++]; });
}

// Triangulation of faces damaged by rounding. If edges cross or a corner lies on an edge, the edge
// becomes a chain of short edges. The face is the region around which the chains wind, with
// multiplicity. Triangles without area fill the space between each edge and the coincident chain.
// The outline of the triangles is therefore the outline of the face for any coordinates, and no
// triangle leaves the face by more than rounding. Crossings become new vertices.
class Chains {
public:
    Chains(TriangleMesh& mesh, const BoundaryFace& face)
        : mesh_(mesh), face_(face), view_(face.normal) {}

    std::vector<Triangle> run() {
        std::vector<std::vector<Crossing::Vertex_handle>> corners;
        for (const auto& loop : face_.loops) {
            auto& handles = corners.emplace_back();
            for (const std::uint32_t v : loop) {
                handles.push_back(cdt_.insert(view_(mesh_.vertices[v])));
                if (handles.back()->info().vertex == kNone) handles.back()->info().vertex = v;
            }
        }
        if (cdt_.dimension() < 2) return fans();
        std::map<Ends, Crossing::Constraint_id> constraints;
        for (const auto& loop : corners) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Ends ends = std::minmax(loop[i], loop[(i + 1) % loop.size()], by_vertex);
                if (ends.first == ends.second || constraints.contains(ends)) continue;
                constraints.emplace(ends, cdt_.insert_constraint(ends.first, ends.second));
            }
        }
        for (const auto v : cdt_.finite_vertex_handles()) {
            if (v->info().vertex == kNone) v->info().vertex = lifted(v->point());
        }
        for (std::size_t l = 0; l < corners.size(); ++l) {
            const auto& loop = corners[l];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::size_t next = (i + 1) % loop.size();
                std::vector<std::uint32_t> chain{loop[i]->info().vertex};
                if (loop[i] != loop[next]) {
                    const Ends ends = std::minmax(loop[i], loop[next], by_vertex);
                    chain = chain_of(constraints.at(ends));
                    if (chain.front() != loop[i]->info().vertex)
                        std::reverse(chain.begin(), chain.end());
                }
                for (std::size_t k = 0; k + 1 < chain.size(); ++k)
                    passes_.add(chain[k], chain[k + 1]);
                fill(face_.loops[l][i], face_.loops[l][next], chain);
            }
        }
        propagate_winding(cdt_, [this](const Corner& from, const Corner& to) {
            return passes_.net(from.vertex, to.vertex);
        });
        append_by_winding(cdt_, triangles_);
        return outline_is_right() ? std::move(triangles_) : fans();
    }

private:
    using Ends = std::pair<Crossing::Vertex_handle, Crossing::Vertex_handle>;
    static bool by_vertex(Crossing::Vertex_handle a, Crossing::Vertex_handle b) {
        return a->info().vertex < b->info().vertex;
    }

    // True if the triangles traverse exactly the edges of the face, up to cancellation.
    bool outline_is_right() const {
        EdgeTraversals rest;
        for (const Triangle& t : triangles_) {
            for (std::size_t i = 0; i < 3; ++i)
                rest.add(t[i], t[(i + 1) % 3]);
        }
        for (const auto& loop : face_.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i)
                rest.add(loop[(i + 1) % loop.size()], loop[i]);
        }
        return rest.cancel();
    }

    // Returns fans, which have the right outline for any coordinates, but lie within the face only
    // if the face's corners are collinear.
    std::vector<Triangle> fans() const {
        std::vector<Triangle> triangles;
        for (const auto& loop : face_.loops) {
            for (std::size_t i = 1; i + 1 < loop.size(); ++i)
                triangles.push_back({loop[0], loop[i], loop[i + 1]});
        }
        return triangles;
    }

    // Returns the point of the face with the given projection.
    std::uint32_t lifted(Point2 seen) {
        Vec3 p;
        p[view_.first] = seen.x();
        p[view_.second] = seen.y();
        const int dropped = 3 - view_.first - view_.second;
        p[dropped] = (face_.offset - dot(face_.normal, p)) / face_.normal[dropped];
        mesh_.vertices.push_back(p);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    // Returns the vertices along an edge. If a crossing lies on a third edge, only the
    // triangulation has the division of the third edge.
    std::vector<std::uint32_t> chain_of(Crossing::Constraint_id id) const {
        std::vector<std::uint32_t> chain;
        Crossing::Vertex_handle last;
        for (auto v = cdt_.vertices_in_constraint_begin(id);
             v != cdt_.vertices_in_constraint_end(id); ++v) {
            while (last != Crossing::Vertex_handle{} && last != *v) {
                Crossing::Vertex_handle next;
                Crossing::Face_handle face;
                int i = 0;
                if (!cdt_.includes_edge(last, *v, next, face, i)) break;
                if (next != *v) chain.push_back(next->info().vertex);
                last = next;
            }
            chain.push_back((*v)->info().vertex);
            last = *v;
        }
        return chain;
    }

    // Fills the space between an edge and its chain.
    void fill(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& chain) {
        std::uint32_t last = to;
        for (auto v = chain.rbegin(); v != chain.rend(); ++v) {
            if (*v != last && *v != from && last != from) triangles_.push_back({from, last, *v});
            last = *v;
        }
    }

    TriangleMesh& mesh_;
    const BoundaryFace& face_;
    Projection view_;
    Crossing cdt_;
    EdgeTraversals passes_;  // traversals by the chains
    std::vector<Triangle> triangles_;
};

// Division of repeated diagonals. Two faces that share two corners may both have the diagonal
// between the corners, or a diagonal of a face may be an edge of a second face, if corners are
// collinear up to rounding. A face that winds twice around a place, also by rounding, has diagonals
// twice there. Each such diagonal gets a separate vertex in the middle, so that no edge is
// repeated; edges of faces stay.
class RepeatedDiagonals {
public:
    RepeatedDiagonals(TriangleMesh& mesh, std::size_t threads) : mesh_(mesh), threads_(threads) {}

    void split() {
        // Sorted by the first vertex of the edge, then the second, …
        std::vector<std::uint32_t> first(mesh_.vertices.size() + 1, 0);
        const auto for_each_side = [&](auto take) {
            for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::uint32_t a = mesh_.triangles[t][i];
                    const std::uint32_t b = mesh_.triangles[t][(i + 1) % 3];
                    take(Side{std::minmax(a, b), mesh_.face[t], t, a < b});
                }
            }
        };
        for_each_side([&](const Side& side) { ++first[side.edge.first + 1]; });
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<Side> sides(3 * mesh_.triangles.size());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for_each_side([&](const Side& side) { sides[next[side.edge.first]++] = side; });
        const auto sides_of = [&](std::uint32_t v) {
            return std::span(sides).subspan(first[v], first[v + 1] - first[v]);
        };
        const auto vertices = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const std::uint32_t v : filter_indices(threads_, vertices, [&](std::uint32_t i) {
                 std::ranges::sort(sides_of(i), [](const Side& a, const Side& b) {
                     return std::tie(a.edge, a.face, a.triangle) <
                            std::tie(b.edge, b.face, b.triangle);
                 });
                 return !is_paired(sides_of(i));
             })) {
            split(sides_of(v));
        }
    }

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    struct Side {
        Edge edge;  // the smaller vertex first
        std::uint32_t face, triangle;
        bool is_forward;
    };

    // True if each edge has exactly two triangles, as nearly all edges have.
    static bool is_paired(std::span<const Side> sides) {
        for (std::size_t i = 0; i < sides.size(); i += 2) {
            if (i + 1 == sides.size() || sides[i].edge != sides[i + 1].edge) return false;
            if (i + 2 < sides.size() && sides[i].edge == sides[i + 2].edge) return false;
        }
        return true;
    }

    void split(std::span<const Side> sides) {
        for (auto begin = sides.begin(); begin != sides.end();) {
            const auto end = std::find_if(begin, sides.end(),
                                          [&](const Side& s) { return s.edge != begin->edge; });
            if (end - begin == 2) {
                begin = end;
                continue;
            }
            // Within a face, a forward and a backward side are a diagonal; an unmatched side
            // belongs to the edge of the face.
            while (begin != end) {
                const auto other =
                    std::find_if(begin, end, [&](const Side& s) { return s.face != begin->face; });
                std::vector<std::uint32_t> there, back;
                for (; begin != other; ++begin)
                    (begin->is_forward ? there : back).push_back(begin->triangle);
                for (std::size_t i = 0; i < std::min(there.size(), back.size()); ++i)
                    split(std::prev(other)->edge, there[i], back[i]);
            }
        }
    }

    void split(Edge edge, std::uint32_t s, std::uint32_t t) {
        const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
        mesh_.vertices.push_back(0.5 * (mesh_.vertices[edge.first] + mesh_.vertices[edge.second]));
        halve(s, edge, middle);
        halve(t, edge, middle);
    }

    static std::size_t side(const Triangle& corners, Edge edge) {
        std::size_t i = 0;
        while (i < 3 && Edge(std::minmax(corners[i], corners[(i + 1) % 3])) != edge)
            ++i;
        return i;
    }

    // Replaces (a, b, c) with the edge a → b by (a, m, c) and (m, b, c). If the triangle has been
    // halved already, the part with the edge is halved.
    void halve(std::uint32_t t, Edge edge, std::uint32_t middle) {
        std::vector<std::uint32_t> open{t};
        while (side(mesh_.triangles[t = open.back()], edge) == 3) {
            open.pop_back();
            const auto& parts = parts_[t];
            open.insert(open.end(), parts.begin(), parts.end());
        }
        const Triangle old = mesh_.triangles[t];
        const std::size_t i = side(old, edge);
        mesh_.triangles[t] = {old[i], middle, old[(i + 2) % 3]};
        parts_[t].push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
        mesh_.triangles.push_back({middle, old[(i + 1) % 3], old[(i + 2) % 3]});
        mesh_.face.push_back(mesh_.face[t]);
    }

    TriangleMesh& mesh_;
    std::size_t threads_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts_;
};

// Triangles of a run of faces. Faces that need new vertices are listed for append(), which numbers
// the vertices.
struct Part {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> face;
    struct OpenFace {
        std::uint32_t face;
        std::size_t before;  // number of triangles of the run before the face
    };
    std::vector<OpenFace> left;
};

Part part_of(const Boundary& boundary, std::size_t begin, std::size_t end) {
    Part part;
    for (std::size_t f = begin; f < end; ++f) {
        const BoundaryFace& face = boundary.faces[f];
        const auto number = static_cast<std::uint32_t>(f);
        if (!ConvexFace(boundary, face).append(part.triangles)) {
            if (const auto round = delaunay(boundary, face)) {
                part.triangles.insert(part.triangles.end(), round->begin(), round->end());
            } else {
                part.left.push_back({number, part.triangles.size()});
            }
        }
        part.face.resize(part.triangles.size(), number);
    }
    return part;
}

void append(const Boundary& boundary, const Part& part, TriangleMesh& mesh) {
    std::size_t done = 0;
    const auto append_up_to = [&](std::size_t end) {
        const auto from = static_cast<std::ptrdiff_t>(std::exchange(done, end));
        const auto to = static_cast<std::ptrdiff_t>(end);
        mesh.triangles.insert(mesh.triangles.end(), part.triangles.begin() + from,
                              part.triangles.begin() + to);
        mesh.face.insert(mesh.face.end(), part.face.begin() + from, part.face.begin() + to);
    };
    for (const Part::OpenFace& left : part.left) {
        append_up_to(left.before);
        std::vector<Triangle> triangles = Chains(mesh, boundary.faces[left.face]).run();
        cancel_opposites(triangles);
        mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
        mesh.face.insert(mesh.face.end(), triangles.size(), left.face);
    }
    append_up_to(part.triangles.size());
}

}  // namespace

TriangleMesh triangulate(const Boundary& boundary, std::size_t threads) {
    constexpr std::size_t kRun = 512;
    TriangleMesh mesh;
    mesh.vertices = boundary.vertices;
    const Runs runs(boundary.faces.size(), kRun);
    make_in_parallel(
        threads, runs.tasks(),
        [&](std::size_t task) { return part_of(boundary, runs.begin(task), runs.end(task)); },
        [&](std::size_t, const Part& part) { append(boundary, part, mesh); });
    RepeatedDiagonals(mesh, threads).split();
    return mesh;
}

}  // namespace ncsim::cda
