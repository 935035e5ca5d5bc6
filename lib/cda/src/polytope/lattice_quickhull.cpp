// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull: starts with a tetrahedron and adds the farthest point that some triangle sees, one at
// a time. The triangles that see the point are removed, and a cone over the rim of the hole is
// added. A triangle whose plane contains the point does not see the point: the triangle stays, and
// the cone extends the triangle's facet.
#include "polytope/lattice_quickhull.h"

#include "ncsim/cda/predicates.h"

#include "exact/none.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

namespace {

struct Triangle {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint32_t, 3> across{};  // neighbour across the edge from corners[i] to the next
    std::int64_t nx = 0, ny = 0, nz = 0;    // outward normal; twice the area
    std::uint32_t seen = kNone;             // first of the points that the triangle sees
    std::uint32_t farthest = kNone;         // farthest of these points
    double distance = 0.0;                  // distance of `farthest`, times |n|
    bool is_gone = false;
    std::uint32_t tested_point = kNone;  // point of the last test
    bool is_visible = false;
};

class Quickhull {
public:
    explicit Quickhull(std::span<const LatticePoint> points)
        : points_(points), next_(points.size(), kNone) {}

    std::optional<HullFacets> operator()() {
        if (points_.size() < 4 || !has_small_extent() || !begin()) return std::nullopt;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (triangles_[t].is_gone || triangles_[t].seen == kNone) continue;
            if (!add_point(triangles_[t].farthest, t)) return std::nullopt;
        }
        HullFacets hull;
        for (const Triangle& t : triangles_) {
            if (!t.is_gone) hull.loops.push_back({t.corners.begin(), t.corners.end()});
        }
        return hull;
    }

private:
    // True if all coordinates are close enough: normals then have 62 bits, and products of normals
    // and differences 91.
    bool has_small_extent() const {
        constexpr std::int64_t kFarthest = std::int64_t{1} << 29;
        const LatticePoint a = points_[0];
        return std::all_of(points_.begin(), points_.end(), [a](LatticePoint p) {
            return std::abs(p.x - a.x) <= kFarthest / 2 && std::abs(p.y - a.y) <= kFarthest / 2 &&
                   std::abs(p.z - a.z) <= kFarthest / 2;
        });
    }

    // Returns the height of `p` above the triangle, times |n|: with the right sign, and 0 only if
    // `p` is in the plane.
    double above(const Triangle& t, std::uint32_t p) const {
        const LatticePoint d = points_[p] - points_[t.corners[0]];
        const double x = static_cast<double>(t.nx) * static_cast<double>(d.x);
        const double y = static_cast<double>(t.ny) * static_cast<double>(d.y);
        const double z = static_cast<double>(t.nz) * static_cast<double>(d.z);
        const double sum = x + y + z;
        constexpr double kRounding = 1e-15;  // more than four roundings of 2^-53
        if (std::abs(sum) > kRounding * (std::abs(x) + std::abs(y) + std::abs(z))) return sum;
        const Int128 exact = static_cast<Int128>(t.nx) * d.x + static_cast<Int128>(t.ny) * d.y +
                             static_cast<Int128>(t.nz) * d.z;
        return static_cast<double>(exact);
    }

    // Adds a triangle and returns the index; kNone if the triangle has no area.
    std::uint32_t add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        Triangle t;
        t.corners = {a, b, c};
        const LatticePoint u = points_[b] - points_[a], v = points_[c] - points_[a];
        t.nx = u.y * v.z - u.z * v.y;
        t.ny = u.z * v.x - u.x * v.z;
        t.nz = u.x * v.y - u.y * v.x;
        if (t.nx == 0 && t.ny == 0 && t.nz == 0) return kNone;
        triangles_.push_back(t);
        return static_cast<std::uint32_t>(triangles_.size()) - 1;
    }

    // Assigns a point to the first triangle from `first` on that sees the point. A point that no
    // triangle sees is in the hull.
    void assign_to_triangle(std::uint32_t p, std::size_t first) {
        for (std::size_t i = first; i < triangles_.size(); ++i) {
            Triangle& t = triangles_[i];
            const double distance = above(t, p);
            if (!(distance > 0.0)) continue;
            next_[p] = t.seen;
            t.seen = p;
            if (distance > t.distance) {
                t.distance = distance;
                t.farthest = p;
            }
            return;
        }
    }

    // Builds the tetrahedron; false if all points lie in a plane.
    bool begin() {
        const auto count = static_cast<std::uint32_t>(points_.size());
        const auto vec = [this](std::uint32_t i, std::uint32_t from) {
            const LatticePoint d = points_[i] - points_[from];
            return Vec3{static_cast<double>(d.x), static_cast<double>(d.y),
                        static_cast<double>(d.z)};
        };
        const auto farthest = [count](const auto& measure) {
            std::uint32_t best = 0;
            double most = -1.0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const double m = measure(i);
                if (m > most) most = m, best = i;
            }
            return best;
        };
        const std::uint32_t a = farthest([&](std::uint32_t i) { return norm(vec(i, 0)); });
        const std::uint32_t b = farthest([&](std::uint32_t i) { return norm(vec(i, a)); });
        const std::uint32_t c =
            farthest([&](std::uint32_t i) { return norm(cross(vec(b, a), vec(i, a))); });
        if (add_triangle(a, b, c) == kNone) return false;
        const Triangle base = triangles_[0];
        const std::uint32_t d = farthest([&](std::uint32_t i) { return std::abs(above(base, i)); });
        const double height = above(base, d);
        if (height == 0.0) return false;
        triangles_.clear();
        // `d` is below the first triangle.
        const std::array<std::uint32_t, 3> abc =
            height < 0.0 ? std::array{a, b, c} : std::array{a, c, b};
        add_triangle(abc[0], abc[1], abc[2]);
        for (std::uint32_t i = 0; i < 3; ++i)
            add_triangle(abc[(i + 1) % 3], abc[i], d);
        if (triangles_.size() != 4) return false;
        triangles_[0].across = {1, 2, 3};
        for (std::uint32_t i = 0; i < 3; ++i)
            triangles_[i + 1].across = {0, 1 + (i + 2) % 3, 1 + (i + 1) % 3};
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i != a && i != b && i != c && i != d) assign_to_triangle(i, 0);
        }
        return true;
    }

    bool is_visible_from(std::uint32_t triangle, std::uint32_t p) {
        Triangle& t = triangles_[triangle];
        if (t.tested_point != p) {
            t.tested_point = p;
            t.is_visible = above(t, p) > 0.0;
        }
        return t.is_visible;
    }

    // Adds a point; false if the cone would have a triangle without area.
    bool add_point(std::uint32_t p, std::uint32_t first) {
        removed_.assign(1, first);
        horizon_.clear();
        triangles_[first].is_gone = true;
        for (std::size_t i = 0; i < removed_.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t other = triangles_[removed_[i]].across[k];
                if (triangles_[other].is_gone) continue;
                if (is_visible_from(other, p)) {
                    triangles_[other].is_gone = true;
                    removed_.push_back(other);
                } else {
                    const Triangle& t = triangles_[removed_[i]];
                    horizon_.push_back({t.corners[k], t.corners[(k + 1) % 3], other});
                }
            }
        }
        const auto begin = static_cast<std::uint32_t>(triangles_.size());
        for (const Edge& e : horizon_) {
            const std::uint32_t made = add_triangle(e.from, e.to, p);
            if (made == kNone) return false;
            triangles_[made].across[0] = e.beyond;
            Triangle& beyond = triangles_[e.beyond];
            for (std::size_t k = 0; k < 3; ++k) {
                if (beyond.corners[k] == e.to && beyond.corners[(k + 1) % 3] == e.from)
                    beyond.across[k] = made;
            }
        }
        // The rim is one loop: a triangle is adjacent to the triangle that begins where the first
        // ends.
        at_.resize(points_.size());
        for (std::uint32_t i = 0; i < horizon_.size(); ++i)
            at_[horizon_[i].from] = begin + i;
        for (std::uint32_t i = 0; i < horizon_.size(); ++i) {
            const std::uint32_t after = at_[horizon_[i].to];
            triangles_[begin + i].across[1] = after;
            triangles_[after].across[2] = begin + i;
        }
        for (const std::uint32_t g : removed_) {
            for (std::uint32_t q = triangles_[g].seen; q != kNone;) {
                const std::uint32_t next = next_[q];
                if (q != p) assign_to_triangle(q, begin);
                q = next;
            }
        }
        return true;
    }

    struct Edge {
        std::uint32_t from, to, beyond;
    };
    std::span<const LatticePoint> points_;
    std::vector<std::uint32_t> next_;  // list of the points that a triangle sees
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> removed_;
    std::vector<Edge> horizon_;
    std::vector<std::uint32_t> at_;
};

}  // namespace

std::optional<HullFacets> lattice_quickhull(std::span<const LatticePoint> points) {
    return Quickhull(points)();
}

}  // namespace ncsim::cda
