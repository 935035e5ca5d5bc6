// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notation: a *line* is where two planes meet; it has a direction D. A *half-edge* is an
// edge of a face with its direction; the face lies on its left. An *owner* is an oriented plane
// together with an origin.
//
//  1. Naming         equal planes, points, owners and lines get equal numbers; pieces of outlines
//                    become intervals on lines
//  2. cancel         drop what two pieces of one owner both have, in opposite directions
//  3. find_corners   where the outline of an owner turns or touches itself
//  4. break_up       cut what is left where any face at the line has a corner
//  5. pair           half-edges of opposite direction; four and more: radially, around material
//  6. trace          half-edges of one owner → loops, turning clockwise at pinched corners
//  7. unite_corners  corners connected through paired edges share a vertex
//  8. write_faces    in an order that depends on the geometry only
#include "stitch.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/disjoint_sets.h"

#include "chunks.h"
#include "groups.h"
#include "loops.h"
#include "naming.h"
#include "none.h"
#include "numbering.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace ncsim::cda {

namespace {

// (a × b) · n for directions of 50 bits and normals of 24.
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

struct HalfEdge {
    std::uint32_t tail, head;  // points
    std::uint32_t owner;
    std::uint32_t line : 30;
    std::uint32_t forward : 1;
    std::uint32_t crowded : 1;  // more than two faces meet here
    std::uint32_t partner = kNone;
    std::uint32_t next = kNone;
};

}  // namespace

class Stitcher::Impl {
public:
    explicit Impl(const Lattice& lattice) : lattice_(lattice) {}

    void take(const Outlines& part) { names_.take(part); }

    Boundary finish() {
        Groups<Interval> covers = names_.finish();
        covers.replace(
            [&](std::size_t line, std::span<Interval> here, std::vector<Interval>& left) {
                cancel(static_cast<std::uint32_t>(line), here, left);
            });
        find_corners(covers);
        for (std::uint32_t i = 0; i < names_.lines(); ++i)
            break_up(i, covers.of(i));
        covers = Groups<Interval>(0);
        asked_ = {};
        ends_ = Groups<std::uint32_t>(0);
        trace();
        names_.forget_directions();
        return write_faces();
    }

private:
    // 2. Where a forward and a backward piece of one owner lie on each other, they cancel; what is
    // left is covered. Where a cover ends, a piece does: there are no more of them.
    void cancel(std::uint32_t line, std::span<Interval> here, std::vector<Interval>& covers) {
        if (here.size() == 2 && here[0].tail == here[1].tail && here[0].head == here[1].head) {
            if (here[0].owner == here[1].owner) return;
            covers.insert(covers.end(), here.begin(), here.end());
            return;
        }
        rank_stops(line, here);
        std::sort(here.begin(), here.end(), [&](const Interval& a, const Interval& b) {
            return std::tuple(a.owner, position(a.tail)) < std::tuple(b.owner, position(b.tail));
        });
        for (std::size_t begin = 0; begin < here.size();) {
            std::size_t end = begin + 1;
            while (end < here.size() && here[end].owner == here[begin].owner)
                ++end;
            if (end == begin + 1) {
                covers.push_back(here[begin]);
                begin = end;
                continue;
            }
            breaks_.clear();
            for (std::size_t i = begin; i < end; ++i)
                breaks_.insert(breaks_.end(), {position(here[i].tail), position(here[i].head)});
            std::sort(breaks_.begin(), breaks_.end());
            breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
            active_.clear();
            std::size_t next = begin;
            for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
                std::erase_if(active_,
                              [&](const Interval* c) { return position(c->head) <= breaks_[b]; });
                while (next < end && position(here[next].tail) <= breaks_[b])
                    active_.push_back(&here[next++]);
                // Pieces of one owner have no inner points in common: one a direction at most.
                if (active_.size() != 1) continue;
                covers.push_back({stops_[breaks_[b]], stops_[breaks_[b + 1]], here[begin].owner,
                                  active_[0]->forward});
            }
            begin = end;
        }
    }

    // The points on a line in order, and the position of each.
    template <class Intervals>
    void rank_stops(std::uint32_t line, const Intervals& here) {
        stops_.clear();
        for (const Interval& i : here)
            stops_.insert(stops_.end(), {i.tail, i.head});
        std::sort(stops_.begin(), stops_.end());
        stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
        by_number_.clear();
        for (const std::uint32_t stop : stops_)
            by_number_.emplace_back(stop, 0U);
        std::sort(stops_.begin(), stops_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return names_.comes_before(line, a, b);
        });
        for (std::uint32_t i = 0; i < stops_.size(); ++i) {
            std::lower_bound(by_number_.begin(), by_number_.end(), std::pair{stops_[i], 0U})
                ->second = i;
        }
    }
    std::uint32_t position(std::uint32_t point) const {
        return std::lower_bound(by_number_.begin(), by_number_.end(), std::pair{point, 0U})->second;
    }

    // 3. Two covers of an owner that follow each other are one edge, unless the owner has a corner
    // between them: another edge of it begins or ends there.
    void find_corners(Groups<Interval>& covers) {
        asked_.assign(names_.points(), kNone);
        std::uint32_t count = 0;
        for (std::size_t line = 0; line < names_.lines(); ++line) {
            const std::span<Interval> here = covers.of(line);
            for (std::size_t i = 1; i < here.size(); ++i) {
                std::uint32_t& asked = asked_[here[i].tail];
                if (asked == kNone && follows(here[i - 1], here[i])) asked = count++;
            }
        }
        ends_ = Groups<std::uint32_t>(count);
        const auto for_each_end = [&](auto take) {
            for (const Interval& c : covers.all()) {
                for (const std::uint32_t end : {c.tail, c.head}) {
                    if (asked_[end] != kNone) take(asked_[end], c.owner);
                }
            }
        };
        for_each_end([&](std::uint32_t asked, std::uint32_t) { ends_.count(asked); });
        ends_.reserve();
        for_each_end([&](std::uint32_t asked, std::uint32_t owner) { ends_.add(asked, owner); });
    }
    // Whether nothing of the owner but two covers ends there; asked only of points that are asked_.
    bool is_passed(std::uint32_t owner, std::uint32_t point) {
        const std::span<const std::uint32_t> owners = ends_.of(asked_[point]);
        return std::count(owners.begin(), owners.end(), owner) == 2;
    }
    static bool follows(const Interval& first, const Interval& second) {
        return first.owner == second.owner && first.head == second.tail &&
               first.forward == second.forward;
    }

    // 4. All owners at a line are cut wherever one of them has a corner.
    void break_up(std::uint32_t line, std::span<Interval> here) {
        joined_.clear();
        for (const Interval& c : here) {
            if (!joined_.empty() && follows(joined_.back(), c) && is_passed(c.owner, c.tail)) {
                joined_.back().head = c.head;
            } else {
                joined_.push_back(c);
            }
        }
        if (joined_.size() == 2 && joined_[0].tail == joined_[1].tail &&
            joined_[0].head == joined_[1].head && joined_[0].forward != joined_[1].forward) {
            const auto h = static_cast<std::uint32_t>(half_edges_.size());
            for (const Interval& c : joined_)
                add_half_edge(c, c.tail, c.head, line);
            half_edges_[h].partner = h + 1;
            half_edges_[h + 1].partner = h;
            return;
        }
        if (joined_.empty()) return;
        rank_stops(line, joined_);
        std::sort(joined_.begin(), joined_.end(), [&](const Interval& a, const Interval& b) {
            return std::tuple(position(a.tail), a.owner) < std::tuple(position(b.tail), b.owner);
        });
        active_.clear();
        std::size_t next = 0;
        for (std::uint32_t b = 0; b + 1 < stops_.size(); ++b) {
            std::erase_if(active_, [&](const Interval* c) { return position(c->head) <= b; });
            while (next < joined_.size() && position(joined_[next].tail) <= b)
                active_.push_back(&joined_[next++]);
            here_.clear();
            for (const Interval* c : active_) {
                here_.push_back(static_cast<std::uint32_t>(half_edges_.size()));
                add_half_edge(*c, stops_[b], stops_[b + 1], line);
            }
            if (!here_.empty()) pair(names_.direction(line), here_);
        }
    }

    void add_half_edge(const Interval& c, std::uint32_t low, std::uint32_t high,
                       std::uint32_t line) {
        half_edges_.push_back({c.forward ? low : high, c.forward ? high : low, c.owner,
                               line & kMostLines, c.forward, false});
    }

    // 5.
    // Around the line, counter-clockwise about D: a half-edge against D has its material on the
    // counter-clockwise side, one along D on the clockwise side; neighbours with nothing but
    // material between them belong together. The angle of a face is that of its normal n for one
    // along D, of −n for one against it, less a quarter turn for both.
    void pair(const Direction& direction, std::vector<std::uint32_t>& here) {
        const auto link = [&](std::uint32_t a, std::uint32_t b) {
            half_edges_[a].partner = b;
            half_edges_[b].partner = a;
        };
        if (here.size() == 2 && half_edges_[here[0]].forward != half_edges_[here[1]].forward) {
            return link(here[0], here[1]);
        }
        const auto normal = [&](std::uint32_t h) {
            const Plane& p = names_.owners()[half_edges_[h].owner].first;
            const int sign = half_edges_[h].forward ? 1 : -1;
            return Direction{sign * std::int64_t{p.nx}, sign * std::int64_t{p.ny},
                             sign * std::int64_t{p.nz}};
        };
        // Angles from the first one on: the half turn [0, π) before [π, 2π).
        const Direction zero = normal(here[0]);
        const auto cross_sign = [&](const Direction& a, const Direction& b) {
            // (a × b) · D with a, b of 24 bits and D of 50.
            const auto c = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
                return static_cast<Int128>(p) * s - static_cast<Int128>(q) * r;
            };
            const Int128 v = c(a.y, a.z, b.y, b.z) * direction.x +
                             c(a.z, a.x, b.z, b.x) * direction.y +
                             c(a.x, a.y, b.x, b.y) * direction.z;
            return v > 0 ? 1 : v < 0 ? -1 : 0;
        };
        const auto is_second_half = [&](const Direction& v) {
            const int s = cross_sign(zero, v);
            return s < 0 || (s == 0 && dot_sign(zero, v) < 0);
        };
        std::sort(here.begin(), here.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Direction va = normal(a);
            const Direction vb = normal(b);
            const bool ha = is_second_half(va);
            const bool hb = is_second_half(vb);
            return ha != hb ? hb : cross_sign(va, vb) > 0;
        });
        for (std::size_t i = 0; i < here.size(); ++i) {
            const std::uint32_t a = here[i];
            const std::uint32_t b = here[(i + 1) % here.size()];
            half_edges_[a].crowded = true;
            if (!half_edges_[a].forward && half_edges_[b].forward) link(a, b);
        }
    }

    Direction direction_of(const HalfEdge& h) const {
        const Direction d = names_.direction(h.line);
        return h.forward ? d : -d;
    }

    // 6. Half-edges by owner. Where an owner has several edges leaving a point, the next one is the
    // first met clockwise from the way back: the wedge between is the face's own.
    void trace() {
        by_owner_ = Groups<std::uint32_t>(names_.owners().size());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h)
            by_owner_.count(half_edges_[h].owner);
        by_owner_.reserve();
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h)
            by_owner_.add(half_edges_[h].owner, h);
        for (std::size_t owner = 0; owner < names_.owners().size(); ++owner) {
            const std::span<std::uint32_t> here = by_owner_.of(owner);
            const Plane& plane = names_.owners()[owner].first;
            const auto tail = [&](std::uint32_t h) { return half_edges_[h].tail; };
            std::sort(here.begin(), here.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair{tail(a), a} < std::pair{tail(b), b};
            });
            for (const std::uint32_t number : here) {
                HalfEdge& h = half_edges_[number];
                auto it = std::partition_point(here.begin(), here.end(),
                                               [&](std::uint32_t e) { return tail(e) < h.head; });
                if (it == here.end() || tail(*it) != h.head) continue;
                h.next = *it;
                const Direction back = -direction_of(h);
                // Clockwise angle from `back`, in [0, 2π): the smaller half turn first.
                const auto half = [&](const Direction& v) {
                    const int s = turn_sign(back, v, plane);
                    return s < 0 ? 0 : s == 0 && dot_sign(back, v) < 0 ? 1 : 2;
                };
                for (++it; it != here.end() && tail(*it) == h.head; ++it) {
                    const Direction best = direction_of(half_edges_[h.next]);
                    const Direction v = direction_of(half_edges_[*it]);
                    const int hv = half(v);
                    const int hb = half(best);
                    if (hv < hb || (hv == hb && turn_sign(v, best, plane) < 0)) h.next = *it;
                }
            }
        }
    }

    Vec3 position_of(std::uint32_t h) const { return names_.point(half_edges_[h].tail); }

    struct Loop {
        std::vector<std::uint32_t> edges;   // the least corner first
        std::vector<std::uint32_t> points;  // their tails
        bool is_hole = false;
    };
    // A face: its outline and the loops that are holes in it.
    struct Face {
        const Loop* outline;
        std::vector<const Loop*> holes;
    };

    // Half-edges by their tails, then by their heads; no two of an owner have both.
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

    // Faces in the order of their least corners. A hole belongs to the innermost outline around
    // it: the one of those around it that begins last. Asked of the middle of an edge of the hole,
    // which is not on an outline: the two meet in corners at most.
    std::vector<Face> faces_of(const std::vector<Loop>& loops, const Plane& plane) const {
        std::vector<Face> faces;
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
        return faces;
    }

    // 7. Corners of faces (tails of half-edges) that are the same corner of the surface: one turns
    // around a vertex from each to the next across a shared edge.
    DisjointSets unite_corners() const {
        DisjointSets corners(half_edges_.size());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            const std::uint32_t p = half_edges_[h].partner;
            if (p != kNone && half_edges_[p].next != kNone) corners.unite(h, half_edges_[p].next);
        }
        return corners;
    }

    // Half-edges that have the same two vertices as another one though they are not its partner:
    // surfaces that touch along an edge and hang together at both ends of it.
    std::vector<bool> find_twins(DisjointSets& corners) const {
        std::vector<std::array<std::uint32_t, 3>> ends;  // tail, head, half-edge
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (!half_edges_[h].crowded || half_edges_[h].next == kNone) continue;
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

    // As many as faces, or a few more: holes.
    std::size_t count_loops() {
        std::size_t loops = 0;
        done_.assign(half_edges_.size(), false);
        for (std::uint32_t start = 0; start < half_edges_.size(); ++start) {
            if (done_[start]) continue;
            ++loops;
            for (std::uint32_t h = start; h != kNone && !done_[h]; h = half_edges_[h].next)
                done_[h] = true;
        }
        done_.assign(half_edges_.size(), false);
        return loops;
    }

    // 8.
    Boundary write_faces() {
        DisjointSets corners = unite_corners();
        const std::vector<bool> is_twin = find_twins(corners);

        Boundary boundary;
        boundary.faces.reserve(count_loops());
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
                // A vertex of its own in the middle tells the edge from its twins.
                const std::uint32_t pair = std::min(h, half_edges_[h].partner);
                const Vec3 head = names_.point(half_edges_[h].head);
                std::uint32_t& middle = middles.try_emplace(pair, kNone).first->second;
                ring.push_back(name(middle, 0.5 * (position_of(h) + head)));
            }
            return ring;
        };
        for (std::size_t owner = 0; owner < names_.owners().size(); ++owner) {
            const auto& [plane, origin] = names_.owners()[owner];
            const Vec3 normal = unit_normal(plane);
            const std::vector<Loop> loops = loops_of(owner);
            for (const Face& face : faces_of(loops, plane)) {
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
        number_shells(boundary, face_of);
        return boundary;
    }

    void number_shells(Boundary& boundary, const std::vector<std::uint32_t>& face_of) const {
        DisjointSets shells(boundary.faces.size());
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            const std::uint32_t p = half_edges_[h].partner;
            if (p != kNone) shells.unite(face_of[h], face_of[p]);
        }
        std::vector<std::uint32_t> number(boundary.faces.size(), kNone);
        for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
            std::uint32_t& n = number[shells.find(f)];
            if (n == kNone) n = boundary.shells++;
            boundary.faces[f].shell = n;
        }
    }

    Lattice lattice_;
    Naming names_;
    std::vector<std::uint32_t> asked_;  // for each point its number among those asked about
    Groups<std::uint32_t> ends_{0};     // at those, the owner of each cover that ends there
    Chunks<HalfEdge> half_edges_;
    Groups<std::uint32_t> by_owner_{0};
    std::vector<bool> done_;
    const LoopPoints loop_points_{[this](std::uint32_t p) { return names_.point(p); },
                                  [this](std::uint32_t p) { return names_.exact(p); }};
    // Of one line, kept for their memory.
    std::vector<std::uint32_t> stops_, breaks_, here_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_number_;
    std::vector<const Interval*> active_;
    std::vector<Interval> joined_;
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

Stitcher::Stitcher(const Lattice& lattice) : impl_(std::make_unique<Impl>(lattice)) {}
Stitcher::~Stitcher() = default;

void Stitcher::take(const Outlines& part) {
    impl_->take(part);
}

Boundary Stitcher::finish() {
    Boundary boundary = impl_->finish();
    // Nothing that follows, from volumes to meshes, would be right.
    if (!is_closed(boundary)) throw std::logic_error("the surface of the part has a gap");
    return boundary;
}

}  // namespace ncsim::cda
