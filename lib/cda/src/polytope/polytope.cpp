// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact clipping of polytopes, volume, and consistency.
#include "ncsim/cda/polytope.h"

#include "exact/none.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace ncsim::cda {

namespace {

// Returns an integer not below (`up`) or not above the coordinate numerator / w; the coordinate
// itself if integer. `approx` is the nearest double of the coordinate.
double outward(Int128 numerator, Int128 w, double approx, bool up) {
    const double nearest = std::round(approx);
    if (std::abs(approx - nearest) > 1e-3) return up ? std::ceil(approx) : std::floor(approx);
    const Int128 difference = numerator - static_cast<std::int64_t>(nearest) * w;
    if (difference == 0) return nearest;
    return up ? nearest + (difference > 0 ? 1.0 : 0.0) : nearest - (difference < 0 ? 1.0 : 0.0);
}

}  // namespace

Side classify_box(const Box& box_units, const Plane& plane) {
    // Evaluates the plane at the corners farthest along and against the normal. Bounds of polytopes
    // are integers below 2^(B+1), so 128 bits hold every product.
    const auto extreme = [&](bool along) {
        const auto term = [&](std::int64_t n, double low, double high) {
            return static_cast<Int128>(n) *
                   static_cast<std::int64_t>(((n > 0) == along) ? high : low);
        };
        return term(plane.nx, box_units.min.x, box_units.max.x) +
               term(plane.ny, box_units.min.y, box_units.max.y) +
               term(plane.nz, box_units.min.z, box_units.max.z);
    };
    if (extreme(true) <= plane.d) return Side::Below;
    if (extreme(false) >= plane.d) return Side::Above;
    return Side::On;
}

std::optional<ConvexPolytope> ConvexPolytope::of(const Cell& cell, const Lattice& lattice) {
    // Starts with a box one unit larger than the bounds; the planes of this box vanish by clipping.
    const LatticePoint min = lattice.round(cell.bounds.min) - LatticePoint{1, 1, 1};
    const LatticePoint max = lattice.round(cell.bounds.max) + LatticePoint{1, 1, 1};
    ConvexPolytope box;
    const std::array<std::int64_t, 2> xs{min.x, max.x};
    const std::array<std::int64_t, 2> ys{min.y, max.y};
    const std::array<std::int64_t, 2> zs{min.z, max.z};
    for (std::size_t i = 0; i < 8; ++i) {
        box.vertices_.push_back(ExactPoint::at({xs[i & 1], ys[(i >> 1) & 1], zs[(i >> 2) & 1]}));
    }
    box.facets_ = {{{-1, 0, 0, -min.x}, {0, 4, 6, 2}, {2, 5, 3, 4}},
                   {{1, 0, 0, max.x}, {1, 3, 7, 5}, {4, 3, 5, 2}},
                   {{0, -1, 0, -min.y}, {0, 1, 5, 4}, {4, 1, 5, 0}},
                   {{0, 1, 0, max.y}, {2, 6, 7, 3}, {0, 5, 1, 4}},
                   {{0, 0, -1, -min.z}, {0, 2, 3, 1}, {0, 3, 1, 2}},
                   {{0, 0, 1, max.z}, {4, 5, 7, 6}, {2, 1, 3, 0}}};
    box.update_bounds();
    return box.clip(cell.planes);
}

ConvexPolytope ConvexPolytope::assemble(std::vector<ExactPoint> vertices,
                                        std::vector<Facet> facets) {
    std::vector<std::uint32_t> renumbered(facets.size(), kNone);
    ConvexPolytope polytope;
    polytope.vertices_ = std::move(vertices);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (facets[i].vertices.empty()) continue;
        renumbered[i] = static_cast<std::uint32_t>(polytope.facets_.size());
        polytope.facets_.push_back(std::move(facets[i]));
    }
    for (Facet& facet : polytope.facets_) {
        for (std::uint32_t& neighbour : facet.neighbours)
            neighbour = renumbered[neighbour];
    }
    polytope.update_bounds();
    return polytope;
}

void ConvexPolytope::update_bounds() {
    bounds_ = {};
    for (const ExactPoint& v : vertices_) {
        const auto corner = [&v](bool up) {
            return Vec3{outward(v.x, v.w, v.approx.x, up), outward(v.y, v.w, v.approx.y, up),
                        outward(v.z, v.w, v.approx.z, up)};
        };
        bounds_.add(corner(false));
        bounds_.add(corner(true));
    }
}

std::optional<std::uint32_t> ConvexPolytope::facet_in(const Plane& plane) const {
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        if (facets_[i].plane == plane) return i;
    }
    return std::nullopt;
}

std::optional<ConvexPolytope> ConvexPolytope::clip(const std::vector<Plane>& planes) const {
    ConvexPolytope current = *this;
    for (const Plane& plane : planes) {
        const Side box = classify_box(current.bounds_, plane);
        if (box == Side::Below) continue;
        if (box == Side::Above) return std::nullopt;
        auto next = current.clip(plane);
        if (!next) return std::nullopt;
        current = std::move(*next);
    }
    return current;
}

// 1. Classify the corners. 2. Clip each facet's loop, with a new corner per cut edge. 3. Close the
// facets along the plane with edges to the new facet. 4. Chain the reversed edges to the new facet.
std::optional<ConvexPolytope> ConvexPolytope::clip(const Plane& plane) const {
    switch (classify_box(bounds_, plane)) {
        case Side::Below: return *this;
        case Side::Above: return std::nullopt;
        case Side::On: break;
    }
    // Step 1.
    std::vector<Side> side(vertices_.size());
    bool any_below = false;
    bool any_above = false;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        side[i] = classify(vertices_[i], plane);
        any_below |= side[i] == Side::Below;
        any_above |= side[i] == Side::Above;
    }
    if (!any_below) return std::nullopt;
    if (!any_above) return *this;

    std::vector<bool> kept(facets_.size());
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        kept[i] = std::any_of(facets_[i].vertices.begin(), facets_[i].vertices.end(),
                              [&](std::uint32_t v) { return side[v] == Side::Below; });
    }

    ConvexPolytope result;
    std::vector<std::uint32_t> new_index(vertices_.size(), kNone);
    const auto keep = [&](std::uint32_t v) {
        if (new_index[v] == kNone) {
            new_index[v] = static_cast<std::uint32_t>(result.vertices_.size());
            result.vertices_.push_back(vertices_[v]);
        }
        return new_index[v];
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cut_edges;
    const auto cut = [&](std::uint32_t u, std::uint32_t v, std::uint32_t f, std::uint32_t g) {
        const auto [it, is_new] = cut_edges.try_emplace(
            std::minmax(u, v), static_cast<std::uint32_t>(result.vertices_.size()));
        if (is_new) {
            // The edge crosses the plane strictly, so the three planes meet in one point.
            result.vertices_.push_back(
                *meet(facets_[std::min(f, g)].plane, facets_[std::max(f, g)].plane, plane));
        }
        return it->second;
    };

    std::vector<std::uint32_t> new_facet(facets_.size(), kNone);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        if (kept[i]) new_facet[i] = count++;
    }
    const std::uint32_t lid = count;  // the facet in `plane`
    struct LidEdge {
        std::uint32_t tail, head, neighbour;
    };
    std::vector<LidEdge> lid_edges;

    // Steps 2 and 3.
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        if (!kept[i]) continue;
        const Facet& facet = facets_[i];
        Facet out;
        out.plane = facet.plane;
        const std::size_t n = facet.vertices.size();
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t u = facet.vertices[k];
            const std::uint32_t v = facet.vertices[(k + 1) % n];
            const std::uint32_t g = facet.neighbours[k];
            if (side[u] == Side::Below) {
                out.vertices.push_back(keep(u));
                // g is kept, because u is also a corner of g
                out.neighbours.push_back(new_facet[g]);
                if (side[v] == Side::Above) {
                    out.vertices.push_back(cut(u, v, i, g));
                    out.neighbours.push_back(lid);
                }
            } else if (side[u] == Side::On) {
                out.vertices.push_back(keep(u));
                if (side[v] == Side::Below) {
                    out.neighbours.push_back(new_facet[g]);
                } else {
                    out.neighbours.push_back(lid);  // into the cut, or along an edge in the plane
                }
            } else if (side[v] == Side::Below) {
                out.vertices.push_back(cut(u, v, i, g));
                out.neighbours.push_back(new_facet[g]);
            }
        }
        for (std::size_t k = 0; k < out.vertices.size(); ++k) {
            if (out.neighbours[k] != lid) continue;
            lid_edges.push_back(
                {out.vertices[(k + 1) % out.vertices.size()], out.vertices[k], new_facet[i]});
        }
        result.facets_.push_back(std::move(out));
    }

    // Step 4.
    Facet top;
    top.plane = plane;
    std::size_t at = 0;
    for (std::size_t step = 0; step < lid_edges.size(); ++step) {
        top.vertices.push_back(lid_edges[at].tail);
        top.neighbours.push_back(lid_edges[at].neighbour);
        const std::uint32_t head = lid_edges[at].head;
        at = static_cast<std::size_t>(
            std::find_if(lid_edges.begin(), lid_edges.end(),
                         [&](const LidEdge& e) { return e.tail == head; }) -
            lid_edges.begin());
        if (at >= lid_edges.size()) break;
    }
    result.facets_.push_back(std::move(top));
    result.update_bounds();
    return result;
}

double ConvexPolytope::volume() const {
    // Relative to the centre, which keeps the precision of polytopes far from the origin.
    const Vec3 centre = bounds_.centre();
    double sixfold = 0.0;
    for (const Facet& facet : facets_) {
        const Vec3 a = vertices_[facet.vertices[0]].approx - centre;
        for (std::size_t i = 1; i + 1 < facet.vertices.size(); ++i) {
            sixfold += dot(a, cross(vertices_[facet.vertices[i]].approx - centre,
                                    vertices_[facet.vertices[i + 1]].approx - centre));
        }
    }
    return sixfold / 6.0;
}

bool ConvexPolytope::is_consistent() const {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Facet& facet : facets_) {
        const std::size_t n = facet.vertices.size();
        if (n < 3 || facet.neighbours.size() != n) return false;
        for (std::size_t k = 0; k < n; ++k) {
            if (classify(vertices_[facet.vertices[k]], facet.plane) != Side::On) return false;
            if (!edges.emplace(facet.vertices[k], facet.vertices[(k + 1) % n]).second) return false;
        }
    }
    for (const auto& [u, v] : edges) {
        if (!edges.contains({v, u})) return false;
    }
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const Facet& facet = facets_[i];
        for (std::size_t k = 0; k < facet.vertices.size(); ++k) {
            if (facet.neighbours[k] >= facets_.size()) return false;
            const Facet& other = facets_[facet.neighbours[k]];
            const std::uint32_t u = facet.vertices[k];
            const std::uint32_t v = facet.vertices[(k + 1) % facet.vertices.size()];
            const auto it = std::find(other.vertices.begin(), other.vertices.end(), v);
            if (it == other.vertices.end()) return false;
            const auto at = static_cast<std::size_t>(it - other.vertices.begin());
            if (other.vertices[(at + 1) % other.vertices.size()] != u) return false;
        }
        for (const ExactPoint& vertex : vertices_) {
            if (classify(vertex, facet.plane) == Side::Above) return false;
        }
    }
    return facets_.size() >= 4;
}

}  // namespace ncsim::cda
