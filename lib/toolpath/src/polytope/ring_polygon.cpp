// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattice polygons around circles, and coarser polygons with parallel sides.
#include "polytope/ring_polygon.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/vec2.h"

#include "polytope/integer_rounding.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace ncsim::toolpath {

namespace {

using Corners = std::vector<std::pair<std::int64_t, std::int64_t>>;

// Returns the corners of all four quadrants from the corners of the first.
Corners all_quadrants(const Corners& first) {
    Corners corners;
    corners.reserve(4 * first.size());
    for (int turn = 0; turn < 4; ++turn) {
        for (auto [x, y] : first) {
            for (int t = 0; t < turn; ++t)
                x = std::exchange(y, x) * -1;
            corners.emplace_back(x, y);
        }
    }
    return corners;
}

// Measures the distances of the nearest side and of the farthest corner from the origin.
void measure(RingPolygon& polygon) {
    // Far more than the rounding of these sums, far less than any measurable length.
    constexpr double kSlack = 1e-14;
    polygon.inner = std::numeric_limits<double>::infinity();
    polygon.outer = 0.0;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const auto [x, y] = polygon.corners[i];
        const auto [u, v] = polygon.corners[(i + 1) % polygon.corners.size()];
        const Vec2 p{static_cast<double>(x), static_cast<double>(y)};
        const Vec2 q{static_cast<double>(u), static_cast<double>(v)};
        polygon.outer = std::max(polygon.outer, norm(p) * (1 + kSlack));
        const double length = norm(q - p);
        if (length > 0) {
            polygon.inner = std::min(polygon.inner, cross(p, q) / length * (1 - kSlack));
        }
    }
}

// True if no corner is straight or reflex. Rounding makes corners reflex if sides are a few units
// long.
bool is_strictly_convex(const Corners& corners) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto& [ax, ay] = corners[i];
        const auto& [bx, by] = corners[(i + 1) % n];
        const auto& [cx, cy] = corners[(i + 2) % n];
        if ((bx - ax) * (cy - by) - (by - ay) * (cx - bx) <= 0) return false;
    }
    return true;
}

}  // namespace

// Corners lie halfway between the side normals 0, 360/k, … degrees.
std::vector<double> corner_cosines(int sides) {
    std::vector<double> cosines(static_cast<std::size_t>(sides / 4));
    for (std::size_t j = 0; j < cosines.size(); ++j) {
        cosines[j] = sin_cos(static_cast<double>(2 * j + 1) * (180.0 / sides)).cos;
    }
    return cosines;
}

// Rounds both coordinates, in each quadrant, away from the axes (circumscribed) or towards the axes
// (inscribed), which can only enlarge (shrink) the polygon.
RingPolygon ring_polygon(std::int64_t b, const std::vector<double>& cosines, Side side) {
    const std::size_t quadrant = cosines.size();
    const double radius = side != Side::Inscribed ? 1.0 / cosines[0] : 1.0;
    Corners first;
    for (std::size_t j = 0; j < quadrant; ++j) {
        // cos(90° - a) instead of the sine makes both diagonals of a quadrant exact mirrors, to the
        // last bit.
        const double x = static_cast<double>(b) * (cosines[j] * radius);
        const double y = static_cast<double>(b) * (cosines[quadrant - 1 - j] * radius);
        first.emplace_back(side != Side::Inscribed ? round_up(x) : round_down(x),
                           side != Side::Inscribed ? round_up(y) : round_down(y));
    }
    RingPolygon polygon;
    polygon.sides = static_cast<int>(4 * quadrant);
    polygon.corners = all_quadrants(first);
    measure(polygon);
    (side != Side::Inscribed ? polygon.inner : polygon.outer) = static_cast<double>(b);
    return polygon;
}

// The chain of sides from the normal x to the normal y extends as far to the left as up, because
// the diagonal is a mirror. So the sides at x and at y are equally far from the origin.
std::vector<RingPolygon> add_coarser(RingPolygon finest) {
    const std::size_t quadrant = finest.corners.size() / 4;
    const Corners corners = finest.corners;
    std::vector<RingPolygon> polygons;
    polygons.push_back(std::move(finest));
    if (!is_strictly_convex(corners)) return polygons;
    for (std::size_t m = 2; m <= quadrant; ++m) {
        if (quadrant % m != 0) continue;
        const std::int64_t half_side = corners[0].second;
        std::int64_t left = 0;
        for (std::size_t j = m; j < quadrant; j += m)
            left += corners[j - 1].first - corners[j].first;
        std::pair<std::int64_t, std::int64_t> at{half_side + left, half_side};
        Corners first{at};
        for (std::size_t j = m; j < quadrant; j += m) {
            at.first += corners[j].first - corners[j - 1].first;
            at.second += corners[j].second - corners[j - 1].second;
            first.push_back(at);
        }
        RingPolygon polygon;
        polygon.sides = static_cast<int>(4 * first.size());
        polygon.corners = all_quadrants(first);
        measure(polygon);
        if (polygon.inner > 0) polygons.push_back(std::move(polygon));
    }
    return polygons;
}

int facets_between(int sides, int other_sides) {
    return sides + other_sides - std::gcd(sides, other_sides);
}

}  // namespace ncsim::toolpath
