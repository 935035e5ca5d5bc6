// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stitching of outlines. Notation: a *line* is the intersection of two planes and has a direction
// D. A *half-edge* is an edge of a face with direction; the face lies on the left. An *owner* is an
// oriented plane with an origin.
//
//  1. Naming         equal planes, points, owners and lines get equal numbers; pieces of outlines
//                    become intervals on lines
//  2. Canceller      cancel coincident pieces of one owner with opposite directions
//  3. Corners        find where the outline of an owner turns or touches itself
//  4. break_up       divide the rest where any face at the line has a corner
//  5. pair           pair opposite half-edges; four and more: radially, around material
//  6. trace          link half-edges of one owner to loops, turning clockwise at pinched corners
//  7. unite_corners  corners connected through paired edges share a vertex
//  8. write_faces    write faces in an order that depends only on the geometry
#include "surface/stitch.h"

#include "ncsim/base/disjoint_sets.h"
#include "ncsim/base/parallel.h"
#include "ncsim/cda/check.h"

#include "exact/chunks.h"
#include "exact/groups.h"
#include "exact/none.h"
#include "surface/half_edges.h"
#include "surface/loops.h"
#include "surface/naming.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace ncsim::cda {

namespace {

// Returns the sign of (a × b) · n for directions of 50 bits and normals of 24.
int turn_sign(const Direction& a, const Direction& b, const Plane& n) {
    const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return static_cast<Int128>(p) * s - static_cast<Int128>(q) * r;
    };
    const Int128 v = minor(a.y, a.z, b.y, b.z) * n.nx + minor(a.z, a.x, b.z, b.x) * n.ny +
                     minor(a.x, a.y, b.x, b.y) * n.nz;
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

int dot_sign(const Direction& a, const Direction& b) {
    const Int128 v = static_cast<Int128>(a.x) * b.x + static_cast<Int128>(a.y) * b.y +
                     static_cast<Int128>(a.z) * b.z;
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

// Owners per task of a thread.
constexpr std::size_t kRun = 512;

}  // namespace

class Stitcher::Impl {
public:
    Impl(const Lattice& lattice, std::size_t threads) : lattice_(lattice), threads_(threads) {}

    void add_part(const Outlines& part) { names_.add_part(part); }
    void add_outside(const Outlines& border) { names_.add_outside(border); }

    Outlines finish_border(const Walls& walls) {
        Groups<Interval> pieces = names_.finish(threads_);
        const auto wall_of = [&](std::uint32_t tail, std::uint32_t head) -> std::optional<Plane> {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto wall = names_.fixed(tail).wall(walls[axis], axis);
                if (!wall || names_.fixed(head).at[axis] != names_.fixed(tail).at[axis]) continue;
                std::array<std::int32_t, 3> normal{};
                normal[axis] = 2;
                return Plane{normal[0], normal[1], normal[2], *wall};
            }
            return std::nullopt;
        };
        const std::vector<BorderEdge> edges = find_border_edges(
            names_, std::move(pieces), [&](std::uint32_t tail, std::uint32_t head) {
                return wall_of(tail, head).has_value();
            });
        Outlines border;
        std::map<Plane, std::uint32_t> planes;
        const auto plane = [&](const Plane& p) {
            const auto [known, is_new] = planes.try_emplace(p, 0U);
            if (is_new) known->second = border.add_plane(p);
            return known->second;
        };
        std::unordered_map<std::uint32_t, std::uint32_t> points;
        const auto point = [&](std::uint32_t p) {
            const auto [known, is_new] =
                points.try_emplace(p, static_cast<std::uint32_t>(border.points().size()));
            if (is_new) {
                const std::array<Plane, 3> at = names_.planes_at(p);
                Outlines::Point made{names_.fixed(p), {plane(at[0]), plane(at[1]), plane(at[2])}};
                std::ranges::sort(made.planes);
                border.add_point(made);
            }
            return known->second;
        };
        for (const auto& [line, i] : edges) {
            const auto& [face, origin] = names_.owners()[i.owner];
            const std::uint32_t tail = point(i.tail), head = point(i.head);
            border.add({2 * plane(face), plane(*wall_of(i.tail, i.head)), origin,
                        i.forward ? tail : head, i.forward ? head : tail});
        }
        border.close();
        return border;
    }

    // True if an edge has no continuation, neither inside nor outside.
    bool has_gap() const {
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (!is_outside(h) && (half_edges_[h].partner == kNone || half_edges_[h].next == kNone))
                return true;
        }
        return false;
    }

    Boundary finish() {
        half_edges_ = pair_half_edges(names_, names_.finish(threads_), threads_);
        trace();
        names_.forget_directions();
        return write_faces();
    }

private:
    bool is_outside(std::uint32_t h) const { return names_.is_outside(half_edges_[h].owner); }
    // True if the surface continues at this edge within the input, not outside.
    bool is_inner(std::uint32_t h) const {
        const std::uint32_t p = half_edges_[h].partner;
        return p != kNone && !is_outside(h) && !is_outside(p);
    }
    Direction direction_of(const HalfEdge& h) const {
        const Direction d = names_.direction(h.line);
        return h.forward ? d : -d;
    }

    // Step 6: links half-edges of each owner. If several edges of an owner leave a point, they are
    // linked by link_pinched().
    void trace() {
        by_owner_ = Groups<std::uint32_t>(names_.owners().size());
        by_tail_ = Groups<std::uint32_t>(names_.points());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (is_outside(h)) continue;
            by_owner_.count(half_edges_[h].owner);
            by_tail_.count(half_edges_[h].tail);
        }
        by_owner_.reserve();
        by_tail_.reserve();
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (!is_outside(h)) by_owner_.add(half_edges_[h].owner, h);
        }
        for (const std::uint32_t h : by_owner_.all())
            by_tail_.add(half_edges_[h].tail, h);
        done_.assign(half_edges_.size(), false);
        std::atomic<std::size_t> loops = 0;
        const Runs runs(names_.owners().size(), kRun);
        in_parallel(threads_, runs.tasks(), [&](std::size_t task) {
            std::size_t here = 0;
            for (std::size_t owner = runs.begin(task); owner < runs.end(task); ++owner) {
                std::vector<std::uint32_t> pinched;
                for (const std::uint32_t h : by_owner_.of(owner)) {
                    const auto leaving = leaving_head_of(half_edges_[h]);
                    if (leaving.size() == 1) half_edges_[h].next = leaving.front();
                    if (leaving.size() > 1) pinched.push_back(h);
                }
                link_pinched(pinched);
                here += count_loops(owner);
            }
            loops += here;
        });
        loops_ = loops;
        by_tail_ = Groups<std::uint32_t>(0);
        done_.assign(half_edges_.size(), false);
    }
    // Returns the half-edges of the same owner that leave the head of a half-edge.
    std::span<const std::uint32_t> leaving_head_of(const HalfEdge& h) const {
        const auto owner_of = [&](std::uint32_t k) { return half_edges_[k].owner; };
        const std::span<const std::uint32_t> here = by_tail_.of(h.head);
        return {std::ranges::lower_bound(here, h.owner, {}, owner_of),
                std::ranges::upper_bound(here, h.owner, {}, owner_of)};
    }

    // Links half-edges of one owner at points that several of its edges leave.
    void link_pinched(std::vector<std::uint32_t>& arriving) {
        const auto head_of = [&](std::uint32_t h) { return half_edges_[h].head; };
        std::ranges::stable_sort(arriving, {}, head_of);
        for (auto first = arriving.begin(); first != arriving.end();) {
            const auto last =
                std::ranges::upper_bound(first, arriving.end(), head_of(*first), {}, head_of);
            link_at_point({first, last}, leaving_head_of(half_edges_[*first]));
            first = last;
        }
    }

    // Links half-edges of one owner that meet in a point. Clockwise from a reversed arriving edge
    // is a wedge of the face, up to a leaving edge. Wedges may be nested: an edge that passes the
    // point, on the way between two other points, separates them. So arriving and leaving edges
    // match like parentheses around the point.
    void link_at_point(std::span<const std::uint32_t> arriving,
                       std::span<const std::uint32_t> leaving) {
        const Plane& plane = names_.owners()[half_edges_[arriving[0]].owner].first;
        struct End {
            std::uint32_t half_edge;
            bool is_arriving;
            Direction away;
        };
        std::vector<End> ends;
        ends.reserve(arriving.size() + leaving.size());
        for (const std::uint32_t h : arriving)
            ends.push_back({h, true, -direction_of(half_edges_[h])});
        for (const std::uint32_t h : leaving)
            ends.push_back({h, false, direction_of(half_edges_[h])});
        // Clockwise angle from the first end, in (0, 2π], as half turn and sign. Of two ends in one
        // direction the leaving edge comes first: the face does not lie between them.
        const Direction zero = ends[0].away;
        const auto half = [&](const Direction& v) {
            const int s = turn_sign(zero, v, plane);
            return s < 0 ? 0 : s == 0 && dot_sign(zero, v) < 0 ? 1 : 2;
        };
        std::sort(ends.begin() + 1, ends.end(), [&](const End& a, const End& b) {
            const int ha = half(a.away), hb = half(b.away);
            if (ha != hb) return ha < hb;
            const int turn = turn_sign(a.away, b.away, plane);
            return turn != 0 ? turn < 0 : b.is_arriving && !a.is_arriving;
        });
        // Twice around: the partners of the last arriving edges are the first leaving edges.
        std::vector<std::uint32_t> open;
        std::vector<bool> is_linked(ends.size(), false);
        for (std::size_t i = 0; i < 2 * ends.size(); ++i) {
            const std::size_t e = i % ends.size();
            if (is_linked[e]) continue;
            if (ends[e].is_arriving) {
                if (i == e) open.push_back(ends[e].half_edge);
            } else if (!open.empty()) {
                half_edges_[open.back()].next = ends[e].half_edge;
                open.pop_back();
                is_linked[e] = true;
            }
        }
    }

    std::size_t count_loops(std::size_t owner) {
        std::size_t loops = 0;
        for (const std::uint32_t start : by_owner_.of(owner)) {
            if (done_[start]) continue;
            ++loops;
            for (std::uint32_t h = start; h != kNone && !done_[h]; h = half_edges_[h].next)
                done_[h] = true;
        }
        return loops;
    }

    Vec3 position_of(std::uint32_t h) const { return names_.point(half_edges_[h].tail); }

    struct Loop {
        std::vector<std::uint32_t> edges;   // the least corner first
        std::vector<std::uint32_t> points;  // tails of `edges`
        bool is_hole = false;
    };
    // A face: an outline and the holes in the outline.
    struct Face {
        const Loop* outline;
        std::vector<const Loop*> holes;
    };

    struct FacesOfOwner {
        std::vector<Loop> loops;
        std::vector<Face> faces;  // refer to `loops`
    };

    // Compares half-edges by tails, then heads; no two half-edges of an owner have equal ends.
    bool comes_first(std::uint32_t h, std::uint32_t k) const {
        const int tails = names_.compare(half_edges_[h].tail, half_edges_[k].tail);
        return tails != 0 ? tails < 0
                          : names_.compare(half_edges_[h].head, half_edges_[k].head) < 0;
    }

    std::vector<Loop> loops_of(std::size_t owner) {
        std::vector<Loop> loops;
        const Plane& plane = names_.owners()[owner].first;
        for (const std::uint32_t start : by_owner_.of(owner)) {
            if (done_[start]) continue;
            Loop loop;
            for (std::uint32_t h = start; h != kNone && !done_[h]; h = half_edges_[h].next) {
                done_[h] = true;
                loop.edges.push_back(h);
            }
            std::rotate(loop.edges.begin(),
                        std::min_element(
                            loop.edges.begin(), loop.edges.end(),
                            [&](std::uint32_t a, std::uint32_t b) { return comes_first(a, b); }),
                        loop.edges.end());
            for (const std::uint32_t h : loop.edges)
                loop.points.push_back(half_edges_[h].tail);
            loop.is_hole = orientation(loop.points, plane, loop_points_) < 0;
            loops.push_back(std::move(loop));
        }
        std::sort(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
            return comes_first(a.edges[0], b.edges[0]);
        });
        return loops;
    }

    // Returns faces in the order of their least corners. A hole belongs to the innermost outline
    // around the hole, which is the last to begin among the outlines around the hole. The test
    // point is the middle of an edge of the hole; it is not on an outline, because hole and outline
    // meet at most in corners.
    FacesOfOwner faces_of(std::size_t number) {
        FacesOfOwner result{loops_of(number), {}};
        const std::vector<Loop>& loops = result.loops;
        const Plane& plane = names_.owners()[number].first;
        std::vector<Face>& faces = result.faces;
        for (const Loop& loop : loops) {
            if (!loop.is_hole) faces.push_back({&loop, {}});
        }
        for (const Loop& loop : loops) {
            if (!loop.is_hole) continue;
            const HalfEdge& edge = half_edges_[loop.edges[0]];
            const auto owner = std::find_if(faces.rbegin(), faces.rend(), [&](const Face& face) {
                return surrounds(face.outline->points, edge.tail, edge.head, plane, loop_points_);
            });
            if (owner == faces.rend()) throw std::logic_error("a hole without an outline");
            owner->holes.push_back(&loop);
        }
        return result;
    }

    // Step 7: unites corners of faces (tails of half-edges) that are the same corner of the
    // surface. A corner and the next corner around the vertex, across a shared edge, are united.
    DisjointSets unite_corners() const {
        DisjointSets corners(half_edges_.size());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            const std::uint32_t p = half_edges_[h].partner;
            if (is_inner(h) && half_edges_[p].next != kNone) corners.unite(h, half_edges_[p].next);
        }
        return corners;
    }

    // Finds half-edges with the same two vertices as a half-edge that is not the partner: surfaces
    // that touch along an edge and are connected at both ends of the edge.
    std::vector<bool> find_twins(DisjointSets& corners) const {
        std::vector<std::array<std::uint32_t, 3>> ends;  // tail, head, half-edge
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (!half_edges_[h].is_non_manifold || half_edges_[h].next == kNone || !is_inner(h))
                continue;
            ends.push_back({corners.find(h), corners.find(half_edges_[h].next), h});
        }
        std::sort(ends.begin(), ends.end());
        std::vector<bool> is_twin(half_edges_.size(), false);
        for (std::size_t i = 1; i < ends.size(); ++i) {
            if (ends[i][0] == ends[i - 1][0] && ends[i][1] == ends[i - 1][1]) {
                is_twin[ends[i][2]] = is_twin[ends[i - 1][2]] = true;
            }
        }
        return is_twin;
    }

    // Step 8: writes faces, loops and vertices.
    Boundary write_faces() {
        DisjointSets corners = unite_corners();
        const std::vector<bool> is_twin = find_twins(corners);

        Boundary boundary;
        boundary.faces.reserve(loops_);
        boundary.vertices.reserve(corners.sets());
        std::vector<std::uint32_t> vertex(half_edges_.size(), kNone);
        std::unordered_map<std::uint32_t, std::uint32_t> middles;
        std::vector<std::uint32_t> face_of(half_edges_.size(), kNone);
        const auto name = [&](std::uint32_t& number, Vec3 p) {
            if (number == kNone) {
                number = static_cast<std::uint32_t>(boundary.vertices.size());
                boundary.vertices.push_back(lattice_.to_mm(p));
            }
            return number;
        };
        const auto ring_of = [&](const Loop& loop) {
            std::vector<std::uint32_t> ring;
            ring.reserve(loop.edges.size());
            for (const std::uint32_t h : loop.edges) {
                ring.push_back(name(vertex[corners.find(h)], position_of(h)));
                face_of[h] = static_cast<std::uint32_t>(boundary.faces.size());
                if (!is_twin[h]) continue;
                // A separate vertex in the middle distinguishes the edge from its twins.
                const std::uint32_t pair = std::min(h, half_edges_[h].partner);
                const Vec3 head = names_.point(half_edges_[h].head);
                std::uint32_t& middle = middles.try_emplace(pair, kNone).first->second;
                ring.push_back(name(middle, 0.5 * (position_of(h) + head)));
            }
            return ring;
        };
        const Runs runs(names_.owners().size(), kRun);
        make_in_parallel(
            threads_, runs.tasks(),
            [&](std::size_t task) {
                std::vector<FacesOfOwner> made;
                for (std::size_t owner = runs.begin(task); owner < runs.end(task); ++owner)
                    made.push_back(faces_of(owner));
                return made;
            },
            [&](std::size_t task, const std::vector<FacesOfOwner>& made) {
                for (std::size_t i = 0; i < made.size(); ++i) {
                    const auto& [plane, origin] = names_.owners()[runs.begin(task) + i];
                    const Vec3 normal = unit_normal(plane);
                    for (const Face& face : made[i].faces) {
                        BoundaryFace out;
                        out.normal = normal;
                        out.offset = offset_mm(plane, lattice_);
                        out.origin = origin;
                        out.loops.push_back(ring_of(*face.outline));
                        for (const Loop* hole : face.holes)
                            out.loops.push_back(ring_of(*hole));
                        boundary.faces.push_back(std::move(out));
                    }
                }
            });
        number_shells(boundary, face_of);
        return boundary;
    }

    void number_shells(Boundary& boundary, const std::vector<std::uint32_t>& face_of) const {
        DisjointSets shells(boundary.faces.size());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (is_inner(h)) shells.unite(face_of[h], face_of[half_edges_[h].partner]);
        }
        std::vector<std::uint32_t> number(boundary.faces.size(), kNone);
        for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
            std::uint32_t& n = number[shells.find(f)];
            if (n == kNone) n = boundary.shells++;
            boundary.faces[f].shell = n;
        }
    }

    Lattice lattice_;
    std::size_t threads_;
    Naming names_;
    Chunks<HalfEdge> half_edges_;
    Groups<std::uint32_t> by_owner_{0};
    Groups<std::uint32_t> by_tail_{0};  // within trace()
    std::size_t loops_ = 0;             // number of faces, plus the number of holes
    std::vector<std::uint8_t> done_;    // bytes, because threads write to adjacent elements
    const LoopPoints loop_points_{[this](std::uint32_t p) { return names_.point(p); },
                                  [this](std::uint32_t p) { return names_.exact(p); }};
};

Outlines outlines_of(const std::vector<Fragment>& fragments) {
    Outlines outlines;
    for (const Fragment& fragment : fragments) {
        const std::uint32_t plane = outlines.add_plane(fragment.plane);
        for (const auto& loop : fragment.loops) {
            std::vector<std::uint32_t> edges;
            edges.reserve(loop.size());
            for (const auto& corner : loop)
                edges.push_back(outlines.add_plane(corner.edge));
            const std::size_t n = loop.size();
            const auto corner = [&](std::size_t i) {
                return outlines.point(plane, edges[(i + n - 1) % n], edges[i % n]);
            };
            for (std::size_t i = 0; i < n; ++i)
                outlines.add({2 * plane, edges[i], fragment.origin, corner(i), corner(i + 1)});
        }
    }
    return outlines;
}

Stitcher::Stitcher(const Lattice& lattice, std::size_t threads)
    : impl_(std::make_unique<Impl>(lattice, threads)) {}
Stitcher::~Stitcher() = default;

void Stitcher::add_part(const Outlines& part) {
    impl_->add_part(part);
}

void Stitcher::add_outside(const Outlines& border) {
    impl_->add_outside(border);
}

Outlines Stitcher::finish_border(const Walls& walls) {
    return impl_->finish_border(walls);
}

Boundary Stitcher::finish_open() {
    Boundary boundary = impl_->finish();
    if (impl_->has_gap()) throw std::logic_error("the surface of the part has a gap");
    return boundary;
}

Boundary Stitcher::finish() {
    Boundary boundary = impl_->finish();
    // With a gap, all later results, from volumes to meshes, would be wrong.
    if (!is_closed(boundary)) throw std::logic_error("the surface of the part has a gap");
    return boundary;
}

}  // namespace ncsim::cda
