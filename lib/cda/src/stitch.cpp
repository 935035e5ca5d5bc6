// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notation: a *line* is where two planes meet; it has a direction D. A *half-edge* is an
// edge of a face with its direction; the face lies on its left. An *owner* is an oriented plane
// together with an origin.
//
//  1. name_points       equal corners get equal numbers
//  2. collect_lines     edges of fragments → intervals on lines
//  3. cancel            drop what two pieces of one owner both have, in opposite directions
//  4. break_up          cut what is left where any face at the line has a corner
//  5. pair              half-edges of opposite direction; four and more: radially, around material
//  6. trace_loops       half-edges of one owner → loops, turning clockwise at pinched corners
//  7. unite_corners     corners connected through paired edges share a vertex
//  8. write_faces       in an order that depends on the geometry only
#include "stitch.h"

#include "numbering.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace ncsim::cda {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct Direction {
    std::int64_t x = 0, y = 0, z = 0;
};

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

struct Interval {
    std::uint32_t tail, head;  // point numbers, tail before head along the line
    std::uint32_t fragment;
    bool forward;
};

// What one owner still has of a line between two neighbouring stops.
struct Cover {
    std::uint32_t from, to;  // positions on the line
    std::uint32_t owner, fragment;
    bool forward;
};

struct Line {
    Direction direction;
    std::vector<Interval> intervals;
    std::vector<std::uint32_t> stops;  // points, in order along the line
    std::vector<Cover> covers;         // by owner, then by position
};

struct HalfEdge {
    std::uint32_t tail, head;  // points
    std::uint32_t owner;
    std::uint32_t component;  // fragments grown together
    std::uint32_t line;
    bool forward;
    std::uint32_t partner = kNone;
    std::uint32_t next = kNone;
};

class Stitcher {
public:
    Stitcher(const std::vector<Fragment>& fragments, const Lattice& lattice)
        : fragments_(fragments), lattice_(lattice), components_(fragments.size()) {}

    Boundary run() {
        number_owners();
        name_points_and_collect_lines();
        for (Line& line : lines_)
            cancel(line);
        for (std::uint32_t i = 0; i < lines_.size(); ++i)
            break_up(i);
        for (HalfEdge& h : half_edges_)
            h.component = components_.find(h.component);
        trace_loops();
        return write_faces();
    }

private:
    void number_owners() {
        std::vector<std::pair<Plane, Origin>> keys;
        keys.reserve(fragments_.size());
        for (const Fragment& f : fragments_)
            keys.emplace_back(f.plane, f.origin);
        owners_ = keys;
        std::sort(owners_.begin(), owners_.end());
        owners_.erase(std::unique(owners_.begin(), owners_.end()), owners_.end());
        for (const auto& key : keys) {
            owner_of_.push_back(static_cast<std::uint32_t>(
                std::lower_bound(owners_.begin(), owners_.end(), key) - owners_.begin()));
        }
    }

    // 1. and 2.
    void name_points_and_collect_lines() {
        std::vector<std::uint32_t> named;
        for (std::uint32_t f = 0; f < fragments_.size(); ++f) {
            for (const auto& loop : fragments_[f].loops) {
                named.clear();
                for (const auto& corner : loop)
                    named.push_back(points_.number(corner.point));
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    const std::uint32_t tail = named[i];
                    const std::uint32_t head = named[(i + 1) % loop.size()];
                    if (tail == head) continue;
                    const LineKey key = line_through(fragments_[f].plane, loop[i].edge);
                    const auto [it, is_new] =
                        line_numbers_.try_emplace(key, static_cast<std::uint32_t>(lines_.size()));
                    if (is_new) lines_.push_back({{key.dx, key.dy, key.dz}, {}, {}, {}});
                    Line& line = lines_[it->second];
                    const bool forward = comes_before(line.direction, tail, head);
                    line.intervals.push_back(
                        {forward ? tail : head, forward ? head : tail, f, forward});
                }
            }
        }
    }

    // Along the axis in which the direction is longest: coordinates are then as far apart as they
    // get.
    bool comes_before(const Direction& d, std::uint32_t a, std::uint32_t b) const {
        const std::array<std::int64_t, 3> c{d.x, d.y, d.z};
        const auto axis = static_cast<int>(
            std::max_element(c.begin(), c.end(),
                             [](auto p, auto q) { return std::abs(p) < std::abs(q); }) -
            c.begin());
        const int order = compare_coordinate(points_[a], points_[b], axis);
        return c[static_cast<std::size_t>(axis)] > 0 ? order < 0 : order > 0;
    }

    // 3. Where a forward and a backward edge of one owner lie on each other, its pieces grow
    // together; what is left is covered. Its ends are corners of the owner.
    void cancel(Line& line) {
        std::vector<std::uint32_t>& stops = line.stops;
        for (const Interval& i : line.intervals)
            stops.insert(stops.end(), {i.tail, i.head});
        std::sort(stops.begin(), stops.end());
        stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
        std::vector<std::uint32_t> by_number = stops;
        std::sort(stops.begin(), stops.end(), [&](std::uint32_t a, std::uint32_t b) {
            return comes_before(line.direction, a, b);
        });
        std::vector<std::uint32_t> positions(stops.size());
        const auto rank = [&](std::uint32_t point) {
            return static_cast<std::size_t>(
                std::lower_bound(by_number.begin(), by_number.end(), point) - by_number.begin());
        };
        for (std::uint32_t i = 0; i < stops.size(); ++i)
            positions[rank(stops[i])] = i;

        std::vector<Cover> stretches;
        for (const Interval& i : line.intervals) {
            stretches.push_back({positions[rank(i.tail)], positions[rank(i.head)],
                                 owner_of_[i.fragment], i.fragment, i.forward});
        }
        std::sort(stretches.begin(), stretches.end(), [](const Cover& a, const Cover& b) {
            return std::tie(a.owner, a.from) < std::tie(b.owner, b.from);
        });
        std::vector<std::uint32_t> breaks;
        std::vector<const Cover*> active;
        for (std::size_t begin = 0; begin < stretches.size();) {
            std::size_t end = begin;
            breaks.clear();
            while (end < stretches.size() && stretches[end].owner == stretches[begin].owner) {
                breaks.insert(breaks.end(), {stretches[end].from, stretches[end].to});
                ++end;
            }
            std::sort(breaks.begin(), breaks.end());
            breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
            active.clear();
            std::size_t next = begin;
            const Cover* last = nullptr;
            for (std::size_t b = 0; b < breaks.size(); ++b) {
                std::erase_if(active, [&](const Cover* c) { return c->to <= breaks[b]; });
                while (next < end && stretches[next].from <= breaks[b]) {
                    active.push_back(&stretches[next++]);
                }
                // Pieces of one owner have no inner points in common: one edge a direction at most.
                if (active.size() == 2) components_.unite(active[0]->fragment, active[1]->fragment);
                const Cover* covering = active.size() == 1 ? active[0] : nullptr;
                const bool continues = covering && last && covering->forward == last->forward;
                if ((covering || last) && !continues) {
                    corners_.insert(corner_key(stretches[begin].owner, stops[breaks[b]]));
                }
                if (covering) {
                    line.covers.push_back({breaks[b], breaks[b + 1], covering->owner,
                                           covering->fragment, covering->forward});
                }
                last = covering;
            }
            begin = end;
        }
    }

    static std::uint64_t corner_key(std::uint32_t owner, std::uint32_t point) {
        return (std::uint64_t{owner} << 32) | point;
    }

    // 4. Covers of an owner are joined where it has no corner (its pieces there surround half of
    // the point and are one); all owners are then cut wherever one of them has a corner.
    void break_up(std::uint32_t number) {
        Line& line = lines_[number];
        std::vector<Cover> joined;
        std::vector<std::uint32_t> breaks;
        for (const Cover& c : line.covers) {
            Cover* last = joined.empty() ? nullptr : &joined.back();
            if (last && last->owner == c.owner && last->to == c.from &&
                last->forward == c.forward &&
                !corners_.contains(corner_key(c.owner, line.stops[c.from]))) {
                last->to = c.to;
                components_.unite(last->fragment, c.fragment);
            } else {
                joined.push_back(c);
            }
        }
        for (const Cover& c : joined)
            breaks.insert(breaks.end(), {c.from, c.to});
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
        std::sort(joined.begin(), joined.end(), [](const Cover& a, const Cover& b) {
            return std::tie(a.from, a.owner) < std::tie(b.from, b.owner);
        });
        std::vector<const Cover*> active;
        std::vector<std::uint32_t> here;
        std::size_t next = 0;
        for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
            std::erase_if(active, [&](const Cover* c) { return c->to <= breaks[b]; });
            while (next < joined.size() && joined[next].from <= breaks[b]) {
                active.push_back(&joined[next++]);
            }
            here.clear();
            const std::uint32_t low = line.stops[breaks[b]];
            const std::uint32_t high = line.stops[breaks[b + 1]];
            for (const Cover* c : active) {
                here.push_back(static_cast<std::uint32_t>(half_edges_.size()));
                half_edges_.push_back({c->forward ? low : high, c->forward ? high : low, c->owner,
                                       c->fragment, number, c->forward});
            }
            if (!here.empty()) pair(line.direction, here);
        }
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
            const Plane& p = owners_[half_edges_[h].owner].first;
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
            if (!half_edges_[a].forward && half_edges_[b].forward) link(a, b);
        }
    }

    Direction direction_of(const HalfEdge& h) const {
        const Direction d = lines_[h.line].direction;
        return h.forward ? d : Direction{-d.x, -d.y, -d.z};
    }

    // 6. Where an owner has several edges leaving a point, the next one is the first met clockwise
    // from the way back: the wedge between is the face's own.
    void trace_loops() {
        std::vector<std::uint32_t> order(half_edges_.size());
        std::iota(order.begin(), order.end(), 0U);
        const auto key = [&](std::uint32_t h) {
            return std::pair{half_edges_[h].owner, half_edges_[h].tail};
        };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair{key(a), a} < std::pair{key(b), b};
        });
        for (HalfEdge& h : half_edges_) {
            const auto range =
                std::equal_range(order.begin(), order.end(), std::pair{h.owner, h.head},
                                 Compare{[&](std::uint32_t e) { return key(e); }});
            if (range.first == range.second) continue;
            h.next = *range.first;
            if (range.second - range.first == 1) continue;
            const Plane& plane = owners_[h.owner].first;
            const Direction d = direction_of(h);
            const Direction back{-d.x, -d.y, -d.z};
            // Clockwise angle from `back`, in [0, 2π): the smaller half turn first.
            const auto half = [&](const Direction& v) {
                const int s = turn_sign(back, v, plane);
                return s < 0 ? 0 : s == 0 && dot_sign(back, v) < 0 ? 1 : 2;
            };
            for (auto it = range.first + 1; it != range.second; ++it) {
                const Direction best = direction_of(half_edges_[h.next]);
                const Direction v = direction_of(half_edges_[*it]);
                const int hv = half(v);
                const int hb = half(best);
                if (hv < hb || (hv == hb && turn_sign(v, best, plane) < 0)) h.next = *it;
            }
        }
    }

    template <class Key>
    struct Compare {
        Key key;
        bool operator()(std::uint32_t e, const std::pair<std::uint32_t, std::uint32_t>& v) const {
            return key(e) < v;
        }
        bool operator()(const std::pair<std::uint32_t, std::uint32_t>& v, std::uint32_t e) const {
            return v < key(e);
        }
    };
    template <class Key>
    Compare(Key) -> Compare<Key>;

    Vec3 position(std::uint32_t h) const { return points_[half_edges_[h].tail].approx; }

    struct Loop {
        std::uint32_t owner, component;
        std::vector<std::uint32_t> edges;
        double area;  // doubled; negative for holes
    };
    // A face: its outline and the loops that are holes in it.
    struct Face {
        std::size_t outline;
        std::vector<std::size_t> holes;
    };

    static bool before(Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
    Vec3 normal_of(const Loop& loop) const { return unit_normal(owners_[loop.owner].first); }

    std::vector<Loop> collect_loops() const {
        std::vector<Loop> loops;
        std::vector<bool> done(half_edges_.size(), false);
        for (std::uint32_t start = 0; start < half_edges_.size(); ++start) {
            if (done[start]) continue;
            Loop loop{half_edges_[start].owner, half_edges_[start].component, {}, 0.0};
            for (std::uint32_t h = start; h != kNone && !done[h]; h = half_edges_[h].next) {
                done[h] = true;
                loop.edges.push_back(h);
            }
            std::rotate(loop.edges.begin(),
                        std::min_element(loop.edges.begin(), loop.edges.end(),
                                         [&](std::uint32_t a, std::uint32_t b) {
                                             return before(position(a), position(b));
                                         }),
                        loop.edges.end());
            const Vec3 normal = normal_of(loop);
            const Vec3 a = position(loop.edges[0]);
            for (std::size_t i = 1; i + 1 < loop.edges.size(); ++i) {
                loop.area += dot(
                    normal, cross(position(loop.edges[i]) - a, position(loop.edges[i + 1]) - a));
            }
            loops.push_back(std::move(loop));
        }
        return loops;
    }

    // Does the outline surround the hole? Asked of the middle of an edge of the hole, which is
    // not on the outline: the two meet in corners at most.
    bool surrounds(const Loop& outline, const Loop& hole) const {
        const Vec3 n = normal_of(outline);
        const Vec3 p =
            0.5 * (position(hole.edges[0]) + points_[half_edges_[hole.edges[0]].head].approx);
        // Crossings of a ray in direction u, with v across it.
        const Vec3 u = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
        const Vec3 v = cross(n, u);
        bool inside = false;
        for (const std::uint32_t e : outline.edges) {
            const Vec3 a = position(e) - p;
            const Vec3 b = points_[half_edges_[e].head].approx - p;
            const double va = dot(a, v);
            const double vb = dot(b, v);
            if ((va > 0.0) == (vb > 0.0)) continue;
            if (dot(a, u) - va * (dot(b, u) - dot(a, u)) / (vb - va) > 0.0) inside = !inside;
        }
        return inside;
    }

    // Pieces that grew together have one outline, or several where they touch in corners only.
    std::vector<Face> collect_faces(const std::vector<Loop>& loops) const {
        std::vector<std::size_t> order(loops.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto first = [&](std::size_t l) { return position(loops[l].edges[0]); };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const Loop& p = loops[a];
            const Loop& q = loops[b];
            if (p.owner != q.owner) return p.owner < q.owner;
            if (p.component != q.component) return p.component < q.component;
            if (p.area != q.area) return p.area > q.area;
            return before(first(a), first(b));
        });
        std::vector<Face> faces;
        for (std::size_t i = 0; i < order.size();) {
            const std::size_t first_face = faces.size();
            const Loop& head = loops[order[i]];
            std::size_t k = i;
            for (; k < order.size() && loops[order[k]].owner == head.owner &&
                   loops[order[k]].component == head.component;
                 ++k) {
                if (k == i || loops[order[k]].area > 0.0) {
                    faces.push_back({order[k], {}});
                    continue;
                }
                // The smallest outline around it; outlines come in order of falling area.
                std::size_t owner = faces.size() - 1;
                while (owner > first_face &&
                       !surrounds(loops[faces[owner].outline], loops[order[k]])) {
                    --owner;
                }
                faces[owner].holes.push_back(order[k]);
            }
            i = k;
        }
        for (Face& face : faces) {
            std::sort(face.holes.begin(), face.holes.end(),
                      [&](std::size_t a, std::size_t b) { return before(first(a), first(b)); });
        }
        std::stable_sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) {
            if (loops[a.outline].owner != loops[b.outline].owner) {
                return loops[a.outline].owner < loops[b.outline].owner;
            }
            return before(first(a.outline), first(b.outline));
        });
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
    std::vector<bool> find_twins(DisjointSets& corners) {
        std::vector<std::array<std::uint32_t, 3>> ends;  // tail, head, half-edge
        for (std::uint32_t h = 0; h < half_edges_.size(); ++h) {
            if (half_edges_[h].next == kNone) continue;
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

    // 8.
    Boundary write_faces() {
        const std::vector<Loop> loops = collect_loops();
        const std::vector<Face> faces = collect_faces(loops);
        DisjointSets corners = unite_corners();
        const std::vector<bool> is_twin = find_twins(corners);

        Boundary boundary;
        std::vector<std::uint32_t> vertex(half_edges_.size(), kNone);
        std::vector<std::uint32_t> middle(half_edges_.size(), kNone);
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
            for (const std::uint32_t h : loop.edges) {
                ring.push_back(name(vertex[corners.find(h)], position(h)));
                face_of[h] = static_cast<std::uint32_t>(boundary.faces.size());
                if (!is_twin[h]) continue;
                // A vertex of its own in the middle tells the edge from its twins.
                const std::uint32_t pair = std::min(h, half_edges_[h].partner);
                const Vec3 head = points_[half_edges_[h].head].approx;
                ring.push_back(name(middle[pair], 0.5 * (position(h) + head)));
            }
            return ring;
        };
        for (const Face& face : faces) {
            BoundaryFace out;
            const auto& [plane, origin] = owners_[loops[face.outline].owner];
            out.normal = unit_normal(plane);
            out.offset = offset_mm(plane, lattice_);
            out.origin = origin;
            out.loops.push_back(ring_of(loops[face.outline]));
            for (const std::size_t hole : face.holes)
                out.loops.push_back(ring_of(loops[hole]));
            boundary.faces.push_back(std::move(out));
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

    const std::vector<Fragment>& fragments_;
    const Lattice& lattice_;
    std::vector<std::pair<Plane, Origin>> owners_;
    std::vector<std::uint32_t> owner_of_;  // fragment → owner
    PointNumbers points_;
    std::unordered_map<LineKey, std::uint32_t, LineKeyHash> line_numbers_;
    std::vector<Line> lines_;
    std::unordered_set<std::uint64_t> corners_;  // of owners, see corner_key
    DisjointSets components_;
    std::vector<HalfEdge> half_edges_;
};

}  // namespace

Boundary stitch(const std::vector<Fragment>& fragments, const Lattice& lattice) {
    return Stitcher(fragments, lattice).run();
}

}  // namespace ncsim::cda
