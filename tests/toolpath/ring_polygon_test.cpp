// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons with integer corners, against all their corners and sides.
#include "polytope/ring_polygon.h"

#include "polytope/integer_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using Corner = std::pair<std::int64_t, std::int64_t>;

double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// Checks radii, orientation, convexity and symmetry of a polygon, corner by corner.
void expect_sound(const RingPolygon& polygon) {
    const std::size_t n = polygon.corners.size();
    ASSERT_EQ(n, static_cast<std::size_t>(polygon.sides));
    double inner = 1e300, outer = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [x, y] = polygon.corners[i];
        const auto [u, v] = polygon.corners[(i + 1) % n];
        const auto [p, q] = polygon.corners[(i + 2) % n];
        EXPECT_GT((u - x) * (q - v) - (v - y) * (p - u), 0) << "convex, counter-clockwise";
        const double side = length(static_cast<double>(u - x), static_cast<double>(v - y));
        inner = std::min(inner, static_cast<double>(x * v - y * u) / side);
        outer = std::max(outer, length(static_cast<double>(x), static_cast<double>(y)));
    }
    EXPECT_LE(polygon.inner, inner + 1e-6);
    EXPECT_GE(polygon.inner, inner - 1e-6) << "no smaller circle than fits";
    EXPECT_GE(polygon.outer, outer - 1e-6);
    EXPECT_LE(polygon.outer, outer + 3.0) << "an inscribed polygon states its circle";
    const std::set<Corner> all(polygon.corners.begin(), polygon.corners.end());
    for (const auto& [x, y] : all) {
        EXPECT_TRUE(all.contains({-y, x})) << "rotated by 90 degrees";
        EXPECT_TRUE(all.contains({y, x})) << "reflected";
    }
}

TEST(RingPolygon, ContainsItsCircleOrIsWithinIt) {
    for (const std::int64_t b : {1000, 12'345, 500'000}) {
        for (const int sides : {4, 8, 12, 24, 64}) {
            SCOPED_TRACE(sides);
            const auto cosines = corner_cosines(sides);
            const RingPolygon around = ring_polygon(b, cosines, Side::Circumscribed);
            expect_sound(around);
            EXPECT_EQ(around.sides, sides);
            EXPECT_GE(around.inner, static_cast<double>(b) - 1e-6);
            std::int64_t widest = 0;
            for (const auto& [x, y] : around.corners)
                widest = std::max(widest, x);
            EXPECT_EQ(widest, b) << "the sides upright to X lie at the radius";
            const double exact = static_cast<double>(b) / std::cos(3.14159265358979 / sides);
            EXPECT_LE(around.outer, exact + 3.0);
            const RingPolygon within = ring_polygon(b, cosines, Side::Inscribed);
            expect_sound(within);
            EXPECT_LE(within.outer, static_cast<double>(b) + 1e-6);
            EXPECT_GE(within.outer, static_cast<double>(b) - 3.0);
        }
    }
}

TEST(RingPolygon, CoarserPolygonsKeepEveryNthSide) {
    const std::int64_t b = 500'000;
    const auto family = add_coarser(ring_polygon(b, corner_cosines(48), Side::Circumscribed));
    std::vector<int> sides;
    sides.reserve(family.size());
    for (const RingPolygon& polygon : family) {
        expect_sound(polygon);
        sides.push_back(polygon.sides);
    }
    // 48 by 1, 2, 3, 4, 6 and 12 are multiples of four sides.
    EXPECT_EQ(sides.front(), 48);
    std::ranges::sort(sides);
    EXPECT_EQ(sides, (std::vector<int>{4, 8, 12, 16, 24, 48}));
    // Each side of a coarser polygon has the direction and the length of a side of the finest.
    const auto ways = [](const RingPolygon& polygon) {
        std::set<Corner> all;
        for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
            const auto [x, y] = polygon.corners[i];
            const auto [u, v] = polygon.corners[(i + 1) % polygon.corners.size()];
            all.insert({u - x, v - y});
        }
        return all;
    };
    const auto finest = ways(family.front());
    for (const RingPolygon& polygon : family) {
        for (const Corner& way : ways(polygon))
            EXPECT_TRUE(finest.contains(way)) << polygon.sides;
    }
}

TEST(RingPolygon, OfAFewUnitsStaysAlone) {
    const auto family = add_coarser(ring_polygon(3, corner_cosines(64), Side::Circumscribed));
    EXPECT_EQ(family.size(), 1U);
}

TEST(RingPolygon, StripsHaveAFacetForEachDirection) {
    EXPECT_EQ(facets_between(24, 24), 24);
    EXPECT_EQ(facets_between(24, 12), 24);
    EXPECT_EQ(facets_between(12, 24), 24);
    EXPECT_EQ(facets_between(24, 16), 24 + 16 - 8) << "8 directions in common";
}

TEST(IntegerRounding, KeepsIntegersButForRounding) {
    EXPECT_EQ(round_up(5.0), 5);
    EXPECT_EQ(round_up(5.0 + 0.9e-7), 5);
    EXPECT_EQ(round_up(5.0 + 1.1e-7), 6);
    EXPECT_EQ(round_up(-5.5), -5);
    EXPECT_EQ(round_down(5.0), 5);
    EXPECT_EQ(round_down(5.0 - 0.9e-7), 5);
    EXPECT_EQ(round_down(5.0 - 1.1e-7), 4);
    EXPECT_EQ(round_down(-5.5), -6);
}

}  // namespace
}  // namespace ncsim::toolpath
