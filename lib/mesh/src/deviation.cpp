// SPDX-License-Identifier: GPL-3.0-or-later
//
// If one mesh was made from the other, most triangles occur in both. Corners that both meshes have
// are skipped. For all other points, the search uses only the triangles that the other mesh does
// not share. If another triangle is nearer to the farthest point than the distance found, the
// search is repeated with all triangles.
#include "deviation.h"

#include "ncsim/base/mix.h"
#include "ncsim/base/triangle_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace ncsim::mesh {

namespace {

using Triple = std::array<std::uint32_t, 3>;

// True if a triangle is within `limit` of `p`; rounding can give false at the limit. `last` is the
// triangle that was near the previous point, which is tried first; it is set to the triangle found.
bool is_within(const TriangleTree& tree, Vec3 p, double limit, std::uint32_t& last) {
    if (distance(p, corners_of(tree.mesh(), last)) <= limit) return true;
    bool found = false;
    tree.visit(
        [&](const Box& box) {
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < box.min[axis] - limit || p[axis] > box.max[axis] + limit)
                    return false;
            }
            return !found;
        },
        [&](std::uint32_t t) {
            if (found || distance(p, corners_of(tree.mesh(), t)) > limit) return;
            found = true;
            last = t;
        });
    return found;
}

struct Farthest {
    double distance = 0.0;
    Vec3 at;
};

// Returns the point farthest from the mesh. The distance of a point is computed only if the point
// is not within the largest distance so far, which is a cheap test.
Farthest farthest(const std::vector<Vec3>& points, const TriangleTree& tree) {
    Farthest result;
    std::uint32_t last = 0;
    for (const Vec3& p : points) {
        if (is_within(tree, p, result.distance, last)) continue;
        const TriangleTree::Nearest nearest = tree.nearest(p);
        if (nearest.distance_mm > result.distance) result = {nearest.distance_mm, p};
        last = nearest.triangle;
    }
    return result;
}

bool is_nearer_than(double limit, Vec3 p, const TriangleMesh& mesh) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const TriangleCorners corners = corners_of(mesh, t);
        bool is_near = true;
        for (int axis = 0; axis < 3 && is_near; ++axis) {
            const auto [low, high] =
                std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
            is_near = p[axis] > low - limit && p[axis] < high + limit;
        }
        if (is_near && distance(p, corners) < limit) return true;
    }
    return false;
}

// Numbers for positions: equal positions in both meshes get equal numbers. A hash table with open
// addressing.
class SamePlaces {
public:
    /// Requires: at most `most` vertices are added.
    explicit SamePlaces(std::size_t most) : slots_(std::bit_ceil(2 * most + 1), kNone) {
        places_.reserve(most);
    }

    std::vector<Triple> triangles(const TriangleMesh& mesh) {
        std::vector<std::uint32_t> place(mesh.vertices.size());
        for (std::size_t v = 0; v < place.size(); ++v)
            place[v] = number(mesh.vertices[v]);
        std::vector<Triple> all;
        all.reserve(mesh.triangles.size());
        for (const Triple& t : mesh.triangles)
            all.push_back({place[t[0]], place[t[1]], place[t[2]]});
        return all;
    }
    std::size_t size() const { return places_.size(); }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::uint32_t number(Vec3 p) {
        std::uint64_t hash = 0;
        for (const double x : {p.x, p.y, p.z})
            hash = mix(hash, std::bit_cast<std::uint64_t>(x + 0.0));
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = static_cast<std::size_t>(hash) & mask;
        for (; slots_[slot] != kNone; slot = (slot + 1) & mask) {
            if (places_[slots_[slot]] == p) return slots_[slot];
        }
        slots_[slot] = static_cast<std::uint32_t>(places_.size());
        places_.push_back(p);
        return slots_[slot];
    }

    std::vector<std::uint32_t> slots_;  // indices into places_
    std::vector<Vec3> places_;
};

// Returns the triangle in a form that does not depend on orientation and starting corner.
Triple sorted(Triple t) {
    std::ranges::sort(t);
    return t;
}

// Set of triangles, grouped by their least corner, which keeps neighbours in space near each other
// in memory.
class TrianglesByCorner {
public:
    TrianglesByCorner(const std::vector<Triple>& triangles, std::size_t places)
        : first_(places + 1, 0), others_(triangles.size()) {
        for (const Triple& t : triangles)
            ++first_[std::ranges::min(t) + std::size_t{1}];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (const Triple& t : triangles) {
            const auto [least, middle, most] = sorted(t);
            others_[next[least]++] = {middle, most};
        }
        for (std::size_t v = 0; v < places; ++v)
            std::sort(others_.begin() + first_[v], others_.begin() + first_[v + 1]);
    }

    bool contain(const Triple& t) const {
        const auto [least, middle, most] = sorted(t);
        const std::pair others{middle, most};
        const auto begin = others_.begin() + first_[least];
        const auto end = others_.begin() + first_[least + std::size_t{1}];
        return std::binary_search(begin, end, others);
    }

private:
    std::vector<std::uint32_t> first_;  // for each position, start of the triangles in others_
    std::vector<std::pair<std::uint32_t, std::uint32_t>> others_;
};

// Triangles that the other mesh does not have, with their corners and middles.
struct UnmatchedTriangles {
    std::vector<std::uint32_t> triangles;
    std::vector<Vec3> points;
};
UnmatchedTriangles unmatched_triangles(const TriangleMesh& mesh,
                                       const std::vector<Triple>& triangles,
                                       const std::vector<Triple>& others, std::size_t places) {
    const TrianglesByCorner in_other(others, places);
    std::vector<bool> is_done(places, false);
    for (const Triple& t : others) {
        for (const std::uint32_t place : t)
            is_done[place] = true;
    }
    UnmatchedTriangles own;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (in_other.contain(triangles[t])) continue;
        own.triangles.push_back(t);
        Vec3 sum;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 corner = mesh.vertices[mesh.triangles[t][i]];
            sum = sum + corner;
            if (is_done[triangles[t][i]]) continue;
            is_done[triangles[t][i]] = true;
            own.points.push_back(corner);
        }
        own.points.push_back((1.0 / 3.0) * sum);
    }
    return own;
}

double farthest(const UnmatchedTriangles& from, const TriangleMesh& to,
                const UnmatchedTriangles& own_of_to) {
    if (from.points.empty()) return 0.0;
    if (!own_of_to.triangles.empty()) {
        const Farthest found = farthest(from.points, TriangleTree(to, own_of_to.triangles));
        if (!is_nearer_than(found.distance, found.at, to)) return found.distance;
    }
    return farthest(from.points, TriangleTree(to)).distance;
}

}  // namespace

double deviation(const TriangleMesh& a, const TriangleMesh& b) {
    if (a.triangles.empty() || b.triangles.empty())
        return a.triangles.empty() == b.triangles.empty() ? 0.0 : Box::kInf;
    SamePlaces places(a.vertices.size() + b.vertices.size());
    const std::vector<Triple> of_a = places.triangles(a);
    const std::vector<Triple> of_b = places.triangles(b);
    const UnmatchedTriangles own_a = unmatched_triangles(a, of_a, of_b, places.size());
    const UnmatchedTriangles own_b = unmatched_triangles(b, of_b, of_a, places.size());
    return std::max(farthest(own_a, b, own_b), farthest(own_b, a, own_a));
}

}  // namespace ncsim::mesh
