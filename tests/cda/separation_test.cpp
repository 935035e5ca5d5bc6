// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests gaps and depths of penetration of convex bodies.
#include "ncsim/cda/separation.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace ncsim::cda {
namespace {

using Points = std::vector<LatticePoint>;

Points box(LatticePoint min, LatticePoint max) {
    Points corners;
    for (const std::int64_t x : {min.x, max.x}) {
        for (const std::int64_t y : {min.y, max.y}) {
            for (const std::int64_t z : {min.z, max.z})
                corners.push_back({x, y, z});
        }
    }
    return corners;
}

// Returns the depth of penetration in units; empty if the bodies share no volume.
std::optional<double> depth_of(const Points& a, const Points& b) {
    if (!common_point(a, b, 0)) return std::nullopt;
    std::vector<Vec3> corners[2];
    Directions directions[2];
    for (const int i : {0, 1}) {
        const auto hull = convex_hull(i == 0 ? a : b, test::kLattice, kStockOrigin);
        const auto body = ConvexPolytope::of(*hull, test::kLattice);
        for (const ExactPoint& p : body->vertices())
            corners[i].push_back(p.approx);
        directions[i] = directions_of(*body);
    }
    return depth(corners[0], directions[0], corners[1], directions[1]);
}

const Points kCube = box({0, 0, 0}, {1000, 1000, 1000});

TEST(Separation, AGapIsProvenToTheUnit) {
    const Points beside = box({1010, 200, 300}, {1500, 900, 700});
    EXPECT_TRUE(body_distance(kCube, beside, 10).is_apart);
    const BodyDistance wider = body_distance(kCube, beside, 11);
    EXPECT_FALSE(wider.is_apart);
    EXPECT_NEAR(wider.distance, 10.0, 1e-9);
    EXPECT_FALSE(common_point(kCube, beside, 0));
}

TEST(Separation, WhatTouchesIsApartButHasNoGap) {
    const Points on_top = box({-500, -500, 1000}, {1500, 1500, 2000});
    EXPECT_TRUE(body_distance(kCube, on_top, 0, {0, 0, 1}).is_apart);
    EXPECT_FALSE(body_distance(kCube, on_top, 1).is_apart);
    EXPECT_FALSE(common_point(kCube, on_top, 0));
}

TEST(Separation, AnOverlapOfOneUnitIsFoundAndMeasured) {
    const Points into = box({999, 200, 300}, {1500, 900, 700});
    EXPECT_FALSE(body_distance(kCube, into, 0).is_apart);
    const auto found = common_point(kCube, into, 0);
    ASSERT_TRUE(found);
    EXPECT_GT(found->x, 999.0);
    EXPECT_LT(found->x, 1000.0);
    EXPECT_NEAR(*depth_of(kCube, into), 1.0, 1e-9);
}

TEST(Separation, AMarginIsTakenOfBoth) {
    const Points into = box({980, 200, 300}, {1500, 900, 700});
    EXPECT_TRUE(common_point(kCube, into, 9));
    EXPECT_FALSE(common_point(kCube, into, 10));
}

TEST(Separation, EdgesThatCrossAreMeasuredAcrossThem) {
    // Two ridges at right angles; the upper ridge's edge is 30 units below the lower ridge's edge.
    const Points below{{-1000, 0, 0},      {1000, 0, 0},       {-1000, -500, -500},
                       {1000, -500, -500}, {-1000, 500, -500}, {1000, 500, -500}};
    const Points above{{0, -1000, -30},   {0, 1000, -30},    {-500, -1000, 470},
                       {-500, 1000, 470}, {500, -1000, 470}, {500, 1000, 470}};
    const auto found = depth_of(below, above);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 30.0, 1e-6);
}

TEST(Separation, FarAwayIsApart) {
    const std::int64_t far = std::int64_t{1} << 35;
    const Points there = box({far, far, far}, {far + 10, far + 10, far + 10});
    EXPECT_TRUE(body_distance(kCube, there, std::int64_t{1} << 34).is_apart);
}

// A plane proves separation, and a point proves overlap. For each pair exactly one proof exists.
TEST(Separation, RandomBodiesAreApartOrOverlap) {
    test::Random random(7);
    int apart = 0, meet = 0;
    for (int i = 0; i < 4000; ++i) {
        SCOPED_TRACE(i);
        Points a, b;
        const LatticePoint way = test::random_point(random, 120'000);
        for (int k = 0; k < 10; ++k) {
            a.push_back(test::random_point(random, 100'000));
            b.push_back(way + test::random_point(random, 60'000));
        }
        const bool is_apart = body_distance(a, b, 0).is_apart;
        const auto deep = depth_of(a, b);
        EXPECT_NE(is_apart, deep.has_value());
        (is_apart ? apart : meet) += 1;
        if (!deep) continue;
        // No shorter displacement separates the bodies, in any direction.
        const Vec3 out =
            *deep * 0.99 *
            normalized(Vec3{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)});
        for (LatticePoint& p : b)
            p = p + LatticePoint{std::llround(out.x), std::llround(out.y), std::llround(out.z)};
        if (*deep > 100.0) {
            EXPECT_TRUE(common_point(a, b, 0));
        }
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(meet, 500);
}

}  // namespace
}  // namespace ncsim::cda
