// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests convex hulls, hulls within a slack, and hulls of translations.
#include "ncsim/cda/hull.h"

#include "ncsim/cda/polytope.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::Random;

std::vector<LatticePoint> cube_corners(std::int64_t size) {
    std::vector<LatticePoint> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back({(i & 1) ? size : 0, (i & 2) ? size : 0, (i & 4) ? size : 0});
    }
    return corners;
}

bool contains(const Cell& cell, LatticePoint p) {
    return std::all_of(cell.planes.begin(), cell.planes.end(),
                       [&](const Plane& h) { return h.nx * p.x + h.ny * p.y + h.nz * p.z <= h.d; });
}

TEST(ConvexHull, OfACubeIsTheCubeExactly) {
    auto points = cube_corners(1000);
    points.push_back({500, 500, 1000});  // in a face
    points.push_back({500, 500, 500});   // inside
    const auto cell = convex_hull(points, kLattice, Origin{3});
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->planes.size(), 6U);
    EXPECT_EQ(cell->origin, Origin{3});
    EXPECT_EQ(ConvexPolytope::of(*cell, kLattice)->volume(), 1e9);
}

TEST(ConvexHull, OfCoplanarPointsIsNothing) {
    const std::vector<LatticePoint> square{
        {0, 0, 5}, {10, 0, 5}, {10, 10, 5}, {0, 10, 5}, {5, 5, 5}};
    EXPECT_FALSE(convex_hull(square, kLattice, kStockOrigin));
    EXPECT_FALSE(convex_hull({}, kLattice, kStockOrigin));
}

TEST(ConvexHull, OutwardHullsLoseNoPointAndInwardHullsStayInside) {
    Random random(21);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        std::vector<LatticePoint> points;
        for (int k = 0; k < 50; ++k)
            points.push_back(test::random_point(random, 20000000));
        const auto outer = convex_hull(points, kLattice, kStockOrigin, Rounding::Outward);
        const auto inner = convex_hull(points, kLattice, kStockOrigin, Rounding::Inward);
        ASSERT_TRUE(outer && inner);
        for (const LatticePoint& p : points)
            EXPECT_TRUE(contains(*outer, p));
        const auto big = ConvexPolytope::of(*outer, kLattice);
        const auto small = ConvexPolytope::of(*inner, kLattice);
        ASSERT_TRUE(big && small);
        EXPECT_LE(small->volume(), big->volume());
        // 2^-24 of 400 mm, on each of about 600,000 mm².
        EXPECT_NEAR(small->volume(), big->volume(), 1e-6 * big->volume());
    }
}

// Returns the points of a cylinder, or of a sharp cone, in two poses that differ by a small tilt,
// like the steps of a rotary move.
std::vector<LatticePoint> leaning_discs(Random& random) {
    std::vector<LatticePoint> points;
    const double height = random.within(1e4, 1e6), radius = random.within(1e4, 1e6);
    const double lean = random.within(0.0, 0.005);
    const bool is_cone = random.one_in(3);
    for (int k = 0; k < 24; ++k) {
        const double x = radius * std::cos(0.2618 * k), y = radius * std::sin(0.2618 * k);
        for (const double z : {0.0, height}) {
            const double r = is_cone && z == 0.0 ? 0.0 : 1.0;
            points.push_back({std::llround(r * x), std::llround(r * y), std::llround(z)});
            points.push_back({std::llround(r * x + lean * z), std::llround(r * y),
                              std::llround(z - lean * r * x)});
        }
    }
    return points;
}

TEST(ConvexHullWithin, ContainsTheHullAndStaysWithinTheSlack) {
    Random random(11);
    std::size_t plain = 0, fewer = 0;
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        const std::vector<LatticePoint> points = leaning_discs(random);
        const double slack = random.within(10, 3000);
        const auto cell = convex_hull_within(points, kLattice, Origin{1}, slack);
        ASSERT_TRUE(cell);
        plain += convex_hull(points, kLattice, Origin{1})->planes.size();
        fewer += cell->planes.size();
        for (const LatticePoint& p : points)
            EXPECT_TRUE(contains(*cell, p));
        // Two nested convex bodies are as far apart as the largest difference of their supports
        // over all directions.
        const auto polytope = ConvexPolytope::of(*cell, kLattice);
        ASSERT_TRUE(polytope);
        for (int k = 0; k < 500; ++k) {
            const Vec3 u =
                normalized(Vec3{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)});
            double hull = -1e300, around = -1e300;
            for (const LatticePoint& p : points)
                hull = std::max(hull, dot(u, kLattice.to_mm(p)));
            for (const ExactPoint& p : polytope->vertices())
                around = std::max(around, dot(u, kLattice.to_mm(p.approx)));
            ASSERT_LE(around - hull, (slack + 0.5) * kLattice.unit_mm);
        }
    }
    EXPECT_LT(fewer, 0.8 * static_cast<double>(plain));
}

TEST(ConvexHullWithin, DoesNotDependOnTheOrderOfThePoints) {
    Random random(12);
    for (int round = 0; round < 20; ++round) {
        std::vector<LatticePoint> points = leaning_discs(random);
        const auto cell = convex_hull_within(points, kLattice, Origin{1}, 500.0);
        std::reverse(points.begin(), points.end());
        EXPECT_EQ(cell->planes, convex_hull_within(points, kLattice, Origin{1}, 500.0)->planes);
    }
}

TEST(ConvexHullWithin, WithoutSlackIsTheHull) {
    const auto points = cube_corners(1000);
    EXPECT_EQ(convex_hull_within(points, kLattice, Origin{3}, 0.0)->planes.size(), 6U);
}

TEST(TranslationSweep, OfACubeAlongXIsABox) {
    const auto sweep = TranslationSweep::of(cube_corners(1000), kLattice);
    ASSERT_TRUE(sweep);
    const Cell cell = (*sweep)({0, 0, 0}, {5000, 0, 0}, Origin{1});
    const auto body = ConvexPolytope::of(cell, kLattice);
    ASSERT_TRUE(body);
    EXPECT_EQ(body->facets().size(), 6U);
    EXPECT_EQ(body->volume(), 6e9);
}

TEST(TranslationSweep, OfACubeAlongTheDiagonalHasTwelveFaces) {
    const auto sweep = TranslationSweep::of(cube_corners(1000), kLattice);
    const auto body =
        ConvexPolytope::of((*sweep)({0, 0, 0}, {1000, 1000, 1000}, Origin{1}), kLattice);
    ASSERT_TRUE(body);
    EXPECT_EQ(body->facets().size(), 12U);
    EXPECT_EQ(body->volume(), 4e9);  // two cubes and the six prisms between: V + |t·A|
}

TEST(TranslationSweep, AtRestIsTheBodyItself) {
    const auto sweep = TranslationSweep::of(cube_corners(1000), kLattice);
    const auto body = ConvexPolytope::of((*sweep)({7, 7, 7}, {7, 7, 7}, Origin{1}), kLattice);
    ASSERT_TRUE(body);
    EXPECT_EQ(body->volume(), 1e9);
}

// Compares the analytic hull with Quickhull on both poses.
TEST(TranslationSweep, AgreesWithTheHullOfBothPoses) {
    Random random(22);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        std::vector<LatticePoint> points;
        for (int k = 0; k < 25; ++k)
            points.push_back(test::random_point(random, 300000));
        const LatticePoint from = test::random_point(random, 3000000);
        const LatticePoint to = test::random_point(random, 3000000);
        const auto sweep = TranslationSweep::of(points, kLattice);
        ASSERT_TRUE(sweep);
        const Cell analytic = (*sweep)(from, to, Origin{1});
        std::vector<LatticePoint> both;
        for (const LatticePoint& p : points) {
            both.push_back(p + from);
            both.push_back(p + to);
        }
        const auto hull = convex_hull(both, kLattice, Origin{1});
        ASSERT_TRUE(hull);
        for (const LatticePoint& p : both)
            EXPECT_TRUE(contains(analytic, p));
        const double a = ConvexPolytope::of(analytic, kLattice)->volume();
        const double b = ConvexPolytope::of(*hull, kLattice)->volume();
        EXPECT_NEAR(a, b, 1e-5 * b);
    }
}

// Rounding moves the four corners of each side of a tilted cylinder off a common plane, so the side
// has two facets. Their planes may coincide once the normals are quantised.
TEST(TranslationSweep, HasNoPlaneTwice) {
    Random random(23);
    std::size_t planes = 0;
    for (int i = 0; i < 300; ++i) {
        const double tilt = 1e-6 * static_cast<double>(random.between(0, 3000000));
        const double turn = 1e-6 * static_cast<double>(random.between(0, 6000000));
        std::vector<LatticePoint> points;
        for (int k = 0; k < 48; ++k) {
            const double angle = 0.26179938779914943 * k;
            const double x = 300000.0 * std::cos(angle);
            const double y = 300000.0 * std::sin(angle);
            const double z = k < 24 ? 0.0 : 5000000.0;
            const double along = std::cos(tilt) * x + std::sin(tilt) * z;
            points.push_back({std::llround(std::cos(turn) * along - std::sin(turn) * y),
                              std::llround(std::sin(turn) * along + std::cos(turn) * y),
                              std::llround(std::cos(tilt) * z - std::sin(tilt) * x)});
        }
        const auto sweep = TranslationSweep::of(points, kLattice);
        ASSERT_TRUE(sweep);
        const LatticePoint to = test::random_point(random, 100000);
        for (Cell cell : {(*sweep)({}, to, Origin{1}), (*sweep)({}, {}, Origin{1}),
                          *convex_hull(points, kLattice, Origin{1})}) {
            planes += cell.planes.size();
            std::sort(cell.planes.begin(), cell.planes.end());
            EXPECT_EQ(std::adjacent_find(cell.planes.begin(), cell.planes.end()),
                      cell.planes.end());
        }
    }
    EXPECT_GT(planes, 900U * 26U);
}

}  // namespace
}  // namespace ncsim::cda
