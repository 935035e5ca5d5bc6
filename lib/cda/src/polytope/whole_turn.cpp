// SPDX-License-Identifier: GPL-3.0-or-later
//
// The volume that an upright body removes on a closed level polygon without a core: the Minkowski
// sum of body and polygon, which is convex. In integers throughout.
#include "ncsim/cda/hull.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace ncsim::cda {

namespace {

// Bound of steps and of distances from the middle: products fit 64 bits, and the normals of walls
// along steps have kNormalBits.
constexpr std::int64_t kFarthest = std::int64_t{1} << kNormalBits;

// Returns twice the area of the triangle as seen from above; > 0 if counter-clockwise.
std::int64_t turn_of(LatticePoint a, LatticePoint b, LatticePoint c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

std::int64_t along(const Plane& p, LatticePoint q) {
    return p.nx * q.x + p.ny * q.y + p.nz * q.z;
}

LatticePoint middle_of(std::span<const LatticePoint> points) {
    LatticePoint sum;
    for (const LatticePoint& p : points)
        sum = sum + (p - points[0]);
    const auto n = static_cast<std::int64_t>(points.size());
    return points[0] + LatticePoint{sum.x / n, sum.y / n, 0};
}

// True if the path winds once around the middle, counter-clockwise, and never turns right.
bool is_convex_about(LatticePoint middle, std::span<const LatticePoint> way) {
    const std::size_t n = way.size();
    int times_upwards = 0;  // upward crossings on the right of the middle
    for (std::size_t i = 0; i < n; ++i) {
        const LatticePoint a = way[i], b = way[(i + 1) % n], c = way[(i + 2) % n];
        if (turn_of(middle, a, b) <= 0 || turn_of(a, b, c) < 0) return false;
        times_upwards += a.y < middle.y && b.y >= middle.y ? 1 : 0;
    }
    return times_upwards == 1;
}

}  // namespace

std::optional<Cell> TranslationSweep::around(std::span<const LatticePoint> turn,
                                             Origin origin) const {
    if (turn.size() < 4) return std::nullopt;
    if (turn.front().x != turn.back().x || turn.front().y != turn.back().y) return std::nullopt;
    const auto [lowest, highest] = std::ranges::minmax(turn, {}, &LatticePoint::z);
    std::vector<LatticePoint> way(turn.begin(), turn.end() - 1);
    const LatticePoint middle = middle_of(way);
    for (const LatticePoint& p : way) {
        if (std::abs(p.x - middle.x) >= kFarthest / 2 || std::abs(p.y - middle.y) >= kFarthest / 2)
            return std::nullopt;
    }
    if (turn_of(middle, way[0], way[1]) < 0) std::ranges::reverse(way);
    if (!is_convex_about(middle, way)) return std::nullopt;

    Cell cell;
    cell.origin = origin;
    cell.normals = normals_;
    cell.planes.reserve(facets_.size() + way.size());
    for (const Plane& facet : facets_) {
        const bool is_level = facet.nx == 0 && facet.ny == 0;
        if (!is_level && facet.nz != 0) return std::nullopt;
        if (is_level) {
            const std::int64_t common = facet.nz > 0 ? lowest.z : highest.z;
            cell.planes.push_back({0, 0, facet.nz, facet.d + facet.nz * common});
            continue;
        }
        // The body contains the origin of its frame and the middle, at every position.
        if (facet.d <= 0) return std::nullopt;
        std::int64_t farthest = along(facet, way[0]);
        for (const LatticePoint& p : way) {
            if (along(facet, middle - p) >= facet.d) return std::nullopt;
            farthest = std::max(farthest, along(facet, p));
        }
        cell.planes.push_back({facet.nx, facet.ny, 0, facet.d + farthest});
    }
    for (std::size_t i = 0; i < way.size(); ++i) {
        const LatticePoint step = way[(i + 1) % way.size()] - way[i];
        const std::int64_t g = std::gcd(step.x, step.y);
        Plane wall{static_cast<std::int32_t>(step.y / g), static_cast<std::int32_t>(-step.x / g), 0,
                   0};
        const auto is_there = [&wall](const Plane& p) {
            return p.nx == wall.nx && p.ny == wall.ny && p.nz == 0;
        };
        if (std::ranges::any_of(facets_, is_there) || is_there(cell.planes.back())) continue;
        for (const LatticePoint& v : vertices_)
            wall.d = std::max(wall.d, along(wall, v));
        wall.d += along(wall, way[i]);
        cell.planes.push_back(wall);
    }
    LatticePoint low = vertices_[0] + turn[0], high = low;
    const auto [lower, upper] = std::ranges::minmax(vertices_, {}, &LatticePoint::z);
    for (const LatticePoint& v : vertices_) {
        for (const LatticePoint& p : way) {
            low = {std::min(low.x, v.x + p.x), std::min(low.y, v.y + p.y), lower.z + highest.z};
            high = {std::max(high.x, v.x + p.x), std::max(high.y, v.y + p.y), upper.z + lowest.z};
        }
    }
    if (low.z >= high.z) return std::nullopt;
    cell.bounds = {lattice_.to_mm(low), lattice_.to_mm(high)};
    return cell;
}

}  // namespace ncsim::cda
