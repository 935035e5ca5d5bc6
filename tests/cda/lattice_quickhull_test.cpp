// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles are a hull if they close, cover each direction once, and have no point above.
#include "polytope/lattice_quickhull.h"

#include "ncsim/cda/predicates.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ncsim::cda {
namespace {

using test::Random;

// Returns six times the signed volume of the tetrahedron.
Int128 orientation(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
    const auto wide = [](std::int64_t v) { return static_cast<Int128>(v); };
    const LatticePoint u = b - a, v = c - a, w = d - a;
    return (wide(u.y) * v.z - wide(u.z) * v.y) * w.x + (wide(u.z) * v.x - wide(u.x) * v.z) * w.y +
           (wide(u.x) * v.y - wide(u.y) * v.x) * w.z;
}

void expect_hull(const HullFacets& hull, const std::vector<LatticePoint>& points) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::set<std::uint32_t> corners;
    for (const auto& loop : hull.loops) {
        ASSERT_EQ(loop.size(), 3U);
        for (std::size_t k = 0; k < 3; ++k) {
            corners.insert(loop[k]);
            EXPECT_TRUE(edges.insert({loop[k], loop[(k + 1) % 3]}).second) << "an edge twice";
        }
        for (const LatticePoint& p : points) {
            ASSERT_LE(orientation(points[loop[0]], points[loop[1]], points[loop[2]], p), 0)
                << "a point outside";
        }
    }
    for (const auto& [from, to] : edges)
        EXPECT_TRUE(edges.contains({to, from})) << "an open edge";
    EXPECT_EQ(corners.size() + hull.loops.size(), edges.size() / 2 + 2) << "not one sphere";
}

TEST(LatticeQuickhull, OfPointsAnywhereIsTheirHull) {
    Random random(21);
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        std::vector<LatticePoint> points;
        for (int i = 0; i < 60; ++i)
            points.push_back(test::random_point(random, round % 2 == 0 ? 1000 : 100000000));
        const auto hull = lattice_quickhull(points);
        ASSERT_TRUE(hull);
        expect_hull(*hull, points);
    }
}

// Most points are in planes and on edges of other points, and some occur twice.
TEST(LatticeQuickhull, OfAFewCoarsePointsIsTheirHullOrNothing) {
    Random random(22);
    int found = 0;
    for (int round = 0; round < 3000; ++round) {
        SCOPED_TRACE(round);
        std::vector<LatticePoint> points;
        for (int i = 0; i < 4 + round % 20; ++i)
            points.push_back(test::random_point(random, 1 + round % 4));
        const auto hull = lattice_quickhull(points);
        if (!hull) continue;
        expect_hull(*hull, points);
        ++found;
    }
    EXPECT_GT(found, 1500);
}

TEST(LatticeQuickhull, OfAToolThatTurnsIsFound) {
    Random random(23);
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        const double radius = random.within(1e4, 1e6), height = random.within(1e4, 1e7);
        const double angle = round % 5 == 0 ? 0.0 : random.within(0.0, 0.1);
        const double aside = round % 3 == 0 ? 0.0 : random.within(0.0, 1e6);
        std::vector<LatticePoint> points;
        for (int k = 0; k < 24; ++k) {
            for (const double z : {0.0, height}) {
                const double x = radius * std::cos(0.2617994 * k);
                const double y = radius * std::sin(0.2617994 * k);
                points.push_back({std::llround(x), std::llround(y), std::llround(z)});
                points.push_back({std::llround(x + aside),
                                  std::llround(std::cos(angle) * y - std::sin(angle) * z),
                                  std::llround(std::sin(angle) * y + std::cos(angle) * z)});
            }
        }
        const auto hull = lattice_quickhull(points);
        ASSERT_TRUE(hull);
        expect_hull(*hull, points);
    }
}

TEST(LatticeQuickhull, OfPointsInAPlaneOrFarApartIsNothing) {
    EXPECT_FALSE(lattice_quickhull(std::vector<LatticePoint>{}));
    EXPECT_FALSE(lattice_quickhull(
        std::vector<LatticePoint>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
    EXPECT_FALSE(lattice_quickhull(
        std::vector<LatticePoint>{{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}, {3, 4, 5}}));
    const std::int64_t far = std::int64_t{1} << 37;
    EXPECT_FALSE(lattice_quickhull(
        std::vector<LatticePoint>{{0, 0, 0}, {far, 0, 0}, {0, far, 0}, {0, 0, far}}));
}

}  // namespace
}  // namespace ncsim::cda
