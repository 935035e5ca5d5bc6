// SPDX-License-Identifier: GPL-3.0-or-later
//
// Space sweep over two polytopes: crowns, crossings, contours, and the assembly of the
// intersection.
#include "space_sweep.h"

#include "ncsim/cda/polygon.h"
#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::bench {

namespace {

using cda::ConvexPolytope;
using cda::ExactPoint;
using cda::Plane;
using cda::Side;

constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct Edge {
    std::uint32_t u = kNone, v = kNone;
    /// Facets with the edge as u → v, and as v → u.
    std::uint32_t left = kNone, right = kNone;
};

// Compares points from top to bottom along z. Points of equal height are ordered as if the plane
// were slightly tilted.
int compare_heights(const ExactPoint& a, const ExactPoint& b) {
    for (const int axis : {2, 1, 0}) {
        if (const int order = cda::compare_coordinate(b, a, axis)) return order;
    }
    return 0;
}

// A polytope with its edges: the doubly connected edge list that the method needs.
struct Solid {
    const ConvexPolytope& body;
    std::vector<Edge> edges;
    std::vector<std::vector<std::uint32_t>> edges_of_facet;

    explicit Solid(const ConvexPolytope& polytope) : body(polytope) {
        const auto& facets = body.facets();
        edges_of_facet.resize(facets.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
        for (std::uint32_t f = 0; f < facets.size(); ++f) {
            const auto& corners = facets[f].vertices;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const std::uint32_t tail = corners[k], head = corners[(k + 1) % corners.size()];
                const auto [place, is_new] = numbers.try_emplace(
                    std::minmax(tail, head), static_cast<std::uint32_t>(edges.size()));
                if (is_new) edges.push_back({tail, head, f, facets[f].neighbours[k]});
                edges_of_facet[f].push_back(place->second);
            }
        }
    }

    const std::vector<ExactPoint>& corners() const { return body.vertices(); }
    const std::vector<ConvexPolytope::Facet>& facets() const { return body.facets(); }
    const Plane& plane(std::uint32_t facet) const { return body.facets()[facet].plane; }
};

// Sides of the corners of a polytope with respect to the facet planes of a second polytope, each
// computed once.
class Sides {
public:
    Sides(const Solid& corners, const Solid& planes)
        : corners_(corners),
          planes_(planes),
          known_(corners.corners().size() * planes.facets().size(), kUnknown) {}

    Side of(std::uint32_t corner, std::uint32_t facet) {
        std::int8_t& known = known_[corner * planes_.facets().size() + facet];
        if (known == kUnknown) {
            known = static_cast<std::int8_t>(
                cda::classify(corners_.corners()[corner], planes_.plane(facet)));
        }
        return static_cast<Side>(known);
    }
    /// True if the corner is in the facet.
    /// Requires: the corner is in the facet's plane.
    bool is_in_facet(std::uint32_t corner, std::uint32_t facet) {
        return std::ranges::none_of(
            planes_.facets()[facet].neighbours,
            [&](std::uint32_t neighbour) { return of(corner, neighbour) == Side::Above; });
    }

private:
    static constexpr std::int8_t kUnknown = 2;
    const Solid& corners_;
    const Solid& planes_;
    std::vector<std::int8_t> known_;
};

struct Special {};

// Point where an edge of a polytope crosses a facet of the second polytope.
struct Crossing {
    ExactPoint point;
    std::uint32_t edge = 0, facet = 0;
    std::uint8_t solid = 0;      ///< Polytope of the edge.
    bool starts_inside = false;  ///< The edge's `u` is below the facet.
};

struct Contact {
    bool is_crossing = false, is_on_rim = false;
    ExactPoint point;
    std::uint32_t rims = 0;  ///< Number of neighbours whose planes contain the point.
};

// Returns the contact of an edge with a facet.
// Requires: the ends of the edge are on different sides of the facet's plane.
Contact contact_of(const Solid& of_edge, const Edge& edge, const Solid& of_facet,
                   std::uint32_t facet) {
    Contact contact;
    contact.point =
        *cda::meet(of_edge.plane(edge.left), of_edge.plane(edge.right), of_facet.plane(facet));
    for (const std::uint32_t neighbour : of_facet.facets()[facet].neighbours) {
        const Side side = cda::classify(contact.point, of_facet.plane(neighbour));
        if (side == Side::Above) return {};
        if (side == Side::On) ++contact.rims;
    }
    contact.is_crossing = contact.rims == 0;
    contact.is_on_rim = contact.rims > 0;
    return contact;
}

class Sweep {
public:
    Sweep(const ConvexPolytope& a, const ConvexPolytope& b)
        : solids_{Solid(a), Solid(b)},
          sides_{Sides(solids_[0], solids_[1]), Sides(solids_[1], solids_[0])} {}

    SpaceSweep result() {
        SpaceSweep found;
        try {
            find_crossings();
            found.body = crossings_.empty() ? contained() : assembled();
            found.outcome = found.body ? SpaceSweep::Outcome::Found : SpaceSweep::Outcome::Empty;
        } catch (const Special&) {
            found.outcome = SpaceSweep::Outcome::Special;
        }
        return found;
    }

private:
    // Edges and facets that start and end at each corner of a polytope, and the edges and facets
    // that the plane meets.
    struct Crown {
        std::vector<std::uint32_t> order;  // of corners
        std::vector<std::vector<std::uint32_t>> starting_edges, starting_facets;
        std::vector<std::uint32_t> last_of_edge, last_of_facet;  // corners
        std::vector<std::uint32_t> edges, facets;                // met by the plane
    };

    static Crown crown_of(const Solid& solid) {
        const std::size_t n = solid.corners().size();
        Crown crown;
        crown.order.resize(n);
        std::iota(crown.order.begin(), crown.order.end(), 0U);
        std::ranges::sort(crown.order, [&](std::uint32_t a, std::uint32_t b) {
            return compare_heights(solid.corners()[a], solid.corners()[b]) < 0;
        });
        std::vector<std::uint32_t> rank(n);
        for (std::uint32_t i = 0; i < n; ++i)
            rank[crown.order[i]] = i;
        crown.starting_edges.resize(n);
        crown.starting_facets.resize(n);
        for (std::uint32_t e = 0; e < solid.edges.size(); ++e) {
            const auto [u, v] = std::pair{solid.edges[e].u, solid.edges[e].v};
            crown.starting_edges[rank[u] < rank[v] ? u : v].push_back(e);
            crown.last_of_edge.push_back(rank[u] < rank[v] ? v : u);
        }
        for (std::uint32_t f = 0; f < solid.facets().size(); ++f) {
            const auto [first, last] = std::ranges::minmax(
                solid.facets()[f].vertices, {}, [&](std::uint32_t v) { return rank[v]; });
            crown.starting_facets[first].push_back(f);
            crown.last_of_facet.push_back(last);
        }
        return crown;
    }

    void find_crossings() {
        crowns_ = {crown_of(solids_[0]), crown_of(solids_[1])};
        std::array<std::size_t, 2> next{};
        while (next[0] < crowns_[0].order.size() && next[1] < crowns_[1].order.size()) {
            const std::uint32_t a = crowns_[0].order[next[0]], b = crowns_[1].order[next[1]];
            const int order = compare_heights(solids_[0].corners()[a], solids_[1].corners()[b]);
            if (order == 0) throw Special{};
            const std::uint8_t solid = order < 0 ? 0 : 1;
            pass(solid, order < 0 ? a : b);
            ++next[solid];
        }
        // Below the lowest corner of a polytope there are no crossings.
    }

    // Updates a crown as the plane passes a corner.
    void pass(std::uint8_t solid, std::uint32_t corner) {
        Crown& crown = crowns_[solid];
        const Crown& other = crowns_[1 - solid];
        std::erase_if(crown.edges,
                      [&](std::uint32_t e) { return crown.last_of_edge[e] == corner; });
        std::erase_if(crown.facets,
                      [&](std::uint32_t f) { return crown.last_of_facet[f] == corner; });
        for (const std::uint32_t edge : crown.starting_edges[corner]) {
            for (const std::uint32_t facet : other.facets)
                meet(solid, edge, facet);
            crown.edges.push_back(edge);
        }
        for (const std::uint32_t facet : crown.starting_facets[corner]) {
            for (const std::uint32_t edge : other.edges)
                meet(static_cast<std::uint8_t>(1 - solid), edge, facet);
            crown.facets.push_back(facet);
        }
    }

    // Tests an edge of `solid` and a facet of the second polytope.
    void meet(std::uint8_t solid, std::uint32_t number, std::uint32_t facet) {
        const Edge& edge = solids_[solid].edges[number];
        Sides& sides = sides_[solid];
        const Side u = sides.of(edge.u, facet), v = sides.of(edge.v, facet);
        if (u == Side::On && sides.is_in_facet(edge.u, facet)) throw Special{};
        if (v == Side::On && sides.is_in_facet(edge.v, facet)) throw Special{};
        if (u == Side::On || v == Side::On || u == v) return;
        const Contact contact = contact_of(solids_[solid], edge, solids_[1 - solid], facet);
        if (contact.is_on_rim) throw Special{};
        if (contact.is_crossing)
            crossings_.push_back({contact.point, number, facet, solid, u == Side::Below});
    }

    // Returns the inner polytope if a polytope contains the second; empty if they are apart.
    // Requires: there is no contour.
    std::optional<ConvexPolytope> contained() {
        for (const std::size_t inner : {0U, 1U}) {
            bool is_inside = true;
            for (std::uint32_t f = 0; f < solids_[1 - inner].facets().size() && is_inside; ++f)
                is_inside = sides_[inner].of(0, f) == Side::Below;
            if (is_inside) return solids_[inner].body;
        }
        return std::nullopt;
    }

    // Edge of the intersection that lies on both surfaces, directed as seen from the first
    // polytope's facet.
    struct Segment {
        std::uint32_t start = kNone, end = kNone, facet_a = 0, facet_b = 0;
    };

    Segment& segment(std::uint32_t a, std::uint32_t b) {
        std::uint32_t& number = segment_of_[a * solids_[1].facets().size() + b];
        if (number == kNone) {
            number = static_cast<std::uint32_t>(segments_.size());
            segments_.push_back({kNone, kNone, a, b});
        }
        return segments_[number];
    }
    static void set(std::uint32_t& end, std::uint32_t crossing) {
        if (end != kNone) throw std::logic_error("a contour forks");
        end = crossing;
    }

    // Links crossings to contours. The direction of the edge at a crossing determines the direction
    // of the contours.
    void link_contours() {
        segment_of_.assign(solids_[0].facets().size() * solids_[1].facets().size(), kNone);
        for (std::uint32_t i = 0; i < crossings_.size(); ++i) {
            const Crossing& c = crossings_[i];
            const Edge& edge = solids_[c.solid].edges[c.edge];
            // Left and right are seen along the edge from inside to outside.
            const std::uint32_t left = c.starts_inside ? edge.left : edge.right;
            const std::uint32_t right = c.starts_inside ? edge.right : edge.left;
            if (c.solid == 0) {
                set(segment(left, c.facet).start, i);
                set(segment(right, c.facet).end, i);
            } else {
                set(segment(c.facet, left).end, i);
                set(segment(c.facet, right).start, i);
            }
        }
        for (const Segment& s : segments_) {
            if (s.start == kNone || s.end == kNone)
                throw std::logic_error("a contour does not close");
        }
    }

    struct Piece {
        std::uint32_t tail, head, neighbour;
    };

    // Returns which corners of `solid` are inside the second polytope. An edge with a crossing
    // determines its ends; both ends of an edge without crossings are on the same side.
    std::vector<bool> inside_of(std::size_t solid,
                                const std::vector<std::vector<std::uint32_t>>& crossings_of_edge) {
        const Solid& s = solids_[solid];
        std::vector<bool> inside(s.corners().size());
        std::vector<std::vector<std::uint32_t>> joined(s.corners().size());
        std::vector<std::uint32_t> waiting;
        const auto enter = [&](std::uint32_t corner) {
            if (inside[corner]) return;
            inside[corner] = true;
            waiting.push_back(corner);
        };
        for (std::uint32_t e = 0; e < s.edges.size(); ++e) {
            const Edge& edge = s.edges[e];
            if (crossings_of_edge[e].empty()) {
                joined[edge.u].push_back(edge.v);
                joined[edge.v].push_back(edge.u);
            } else if (crossings_of_edge[e].size() == 1) {
                enter(crossings_[crossings_of_edge[e][0]].starts_inside ? edge.u : edge.v);
            }
        }
        while (!waiting.empty()) {
            const std::uint32_t corner = waiting.back();
            waiting.pop_back();
            for (const std::uint32_t other : joined[corner])
                enter(other);
        }
        return inside;
    }

    std::optional<ConvexPolytope> assembled() {
        link_contours();
        std::vector<ExactPoint> corners;
        for (const Crossing& c : crossings_)
            corners.push_back(c.point);
        const auto first = static_cast<std::uint32_t>(solids_[0].facets().size());
        std::vector<ConvexPolytope::Facet> facets(first + solids_[1].facets().size());
        std::vector<std::vector<Piece>> pieces(facets.size());
        for (const Segment& s : segments_) {
            pieces[s.facet_a].push_back({s.start, s.end, first + s.facet_b});
            pieces[first + s.facet_b].push_back({s.end, s.start, s.facet_a});
        }
        for (std::uint32_t solid = 0; solid < 2; ++solid)
            add_inner_edges(solid, solid == 0 ? 0 : first, corners, pieces);
        std::vector<std::uint32_t> piece_at(corners.size(), kNone);
        for (std::uint32_t f = 0; f < facets.size(); ++f) {
            facets[f].plane = f < first ? solids_[0].plane(f) : solids_[1].plane(f - first);
            chain(pieces[f], piece_at, facets[f]);
        }
        return ConvexPolytope::assemble(std::move(corners), std::move(facets));
    }

    // Adds the parts of a polytope's own edges that are inside the second polytope.
    void add_inner_edges(std::uint32_t solid, std::uint32_t first, std::vector<ExactPoint>& corners,
                         std::vector<std::vector<Piece>>& pieces) {
        const Solid& s = solids_[solid];
        std::vector<std::vector<std::uint32_t>> crossings_of_edge(s.edges.size());
        for (std::uint32_t i = 0; i < crossings_.size(); ++i) {
            if (crossings_[i].solid == solid) crossings_of_edge[crossings_[i].edge].push_back(i);
        }
        const std::vector<bool> inside = inside_of(solid, crossings_of_edge);
        std::vector<std::uint32_t> number(s.corners().size(), kNone);
        for (std::uint32_t v = 0; v < number.size(); ++v) {
            if (!inside[v]) continue;
            number[v] = static_cast<std::uint32_t>(corners.size());
            corners.push_back(s.corners()[v]);
        }
        for (std::uint32_t e = 0; e < s.edges.size(); ++e) {
            const Edge& edge = s.edges[e];
            std::uint32_t from = number[edge.u], to = number[edge.v];
            for (const std::uint32_t i : crossings_of_edge[e])
                (crossings_[i].starts_inside ? to : from) = i;
            if (from == kNone && to == kNone) continue;
            if (from == kNone || to == kNone)
                throw std::logic_error("an edge enters and does not leave");
            pieces[first + edge.left].push_back({from, to, first + edge.right});
            pieces[first + edge.right].push_back({to, from, first + edge.left});
        }
    }

    static void chain(const std::vector<Piece>& pieces, std::vector<std::uint32_t>& piece_at,
                      ConvexPolytope::Facet& facet) {
        if (pieces.empty()) return;
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            piece_at[pieces[i].tail] = i;
        std::uint32_t at = 0;
        do {
            facet.vertices.push_back(pieces[at].tail);
            facet.neighbours.push_back(pieces[at].neighbour);
            at = piece_at[pieces[at].head];
        } while (at != 0 && at != kNone && facet.vertices.size() < pieces.size());
        if (at != 0 || facet.vertices.size() != pieces.size())
            throw std::logic_error("a facet does not close");
        for (const Piece& piece : pieces)
            piece_at[piece.tail] = kNone;
    }

    std::array<Solid, 2> solids_;
    std::array<Sides, 2> sides_;
    std::array<Crown, 2> crowns_;
    std::vector<Crossing> crossings_;
    std::vector<std::uint32_t> segment_of_;
    std::vector<Segment> segments_;
};

bool is_equal(const ConvexPolytope& a, const ConvexPolytope& b) {
    const auto planes = [](const ConvexPolytope& p) {
        std::vector<Plane> all;
        for (const auto& facet : p.facets())
            all.push_back(facet.plane);
        std::ranges::sort(all);
        return all;
    };
    return a.facets().size() == b.facets().size() && planes(a) == planes(b);
}

}  // namespace

SpaceSweep sweep_intersection(const ConvexPolytope& a, const ConvexPolytope& b) {
    return Sweep(a, b).result();
}

SpecialPosition special_position(const ConvexPolytope& a, const ConvexPolytope& b) {
    SpecialPosition position;
    position.equal = is_equal(a, b);
    const std::array<Solid, 2> solids{Solid(a), Solid(b)};
    for (const std::size_t one : {0U, 1U}) {
        const Solid& mine = solids[one];
        const Solid& other = solids[1 - one];
        Sides sides(mine, other);
        for (std::uint32_t f = 0; f < other.facets().size(); ++f) {
            for (std::uint32_t v = 0; v < mine.corners().size(); ++v) {
                if (sides.of(v, f) == Side::On && sides.is_in_facet(v, f))
                    position.corner_on_surface = true;
            }
            for (const Edge& edge : mine.edges) {
                const Side u = sides.of(edge.u, f), v = sides.of(edge.v, f);
                if (u == v || u == Side::On || v == Side::On) continue;
                // Two rims are a corner of the second polytope.
                if (contact_of(mine, edge, other, f).rims == 1) position.edge_on_edge = true;
            }
        }
    }
    for (std::uint32_t i = 0; i < a.facets().size(); ++i) {
        for (std::uint32_t k = 0; k < b.facets().size(); ++k) {
            const bool same = a.facets()[i].plane == b.facets()[k].plane;
            if (!same && a.facets()[i].plane != b.facets()[k].plane.opposite()) continue;
            const auto polygon = cda::ConvexPolygon::of_facet(a, i);
            const auto other = cda::ConvexPolygon::of_facet(b, k);
            if (!cda::below(polygon, std::span<const Plane>(other.edges))) continue;
            (same ? position.facets_one_side : position.facets_face_to_face) = true;
        }
    }
    return position;
}

}  // namespace ncsim::bench
