// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests convex polytopes: construction, clipping and classification.
#include "ncsim/cda/polytope.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

constexpr double kCubicMm = 1e15;  // cubic units in a cubic millimetre

TEST(ConvexPolytope, OfABoxHasItsSixFacesAndItsVolume) {
    const auto box = ConvexPolytope::of(mm_box(0, 0, 0, 2, 3, 4), kLattice);
    ASSERT_TRUE(box);
    EXPECT_EQ(box->facets().size(), 6U);
    EXPECT_EQ(box->vertices().size(), 8U);
    EXPECT_EQ(box->volume(), 24.0 * kCubicMm);
    EXPECT_TRUE(box->is_consistent());
}

TEST(ConvexPolytope, OfAFlatOrEmptyCellIsNothing) {
    EXPECT_FALSE(ConvexPolytope::of(mm_box(0, 0, 0, 2, 3, 0), kLattice));
    Cell empty = mm_box(0, 0, 0, 2, 3, 1);
    empty.planes.push_back({0, 0, 1, -1});
    EXPECT_FALSE(ConvexPolytope::of(empty, kLattice));
}

TEST(Clip, ByAPlaneThroughTwoOppositeEdgesHalvesTheCube) {
    const auto cube = ConvexPolytope::of(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    const auto wedge = cube->clip(Plane{1, -1, 0, 0});
    ASSERT_TRUE(wedge);
    EXPECT_EQ(wedge->facets().size(), 5U);
    EXPECT_EQ(wedge->vertices().size(), 6U);
    EXPECT_EQ(wedge->volume(), 0.5 * kCubicMm);
    EXPECT_TRUE(wedge->is_consistent());
}

TEST(Clip, ByAPlaneThroughACornerOnlyChangesNothing) {
    const auto cube = ConvexPolytope::of(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    const auto same = cube->clip(Plane{1, 1, 1, 300000});
    ASSERT_TRUE(same);
    EXPECT_EQ(same->facets().size(), 6U);
    EXPECT_FALSE(cube->clip(Plane{-1, -1, -1, -300000}));
}

TEST(Clip, AtOneUnitLeavesALayerOfOneUnit) {
    const auto cube = ConvexPolytope::of(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    const auto layer = cube->clip(Plane{0, 0, 1, 1});
    ASSERT_TRUE(layer);
    EXPECT_EQ(layer->volume(), 1e10);
}

TEST(Clip, RandomHullsAreConsistentAndBothSidesAddUp) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const auto body = ConvexPolytope::of(test::random_hull(random, {}, 1000000, 30), kLattice);
        ASSERT_TRUE(body);
        EXPECT_TRUE(body->is_consistent());
        const auto n = test::random_point(random, 1 << 24);
        const Plane plane = canonical(n.x, n.y, n.z | 1, 0);
        const auto below = body->clip(plane);
        const auto above = body->clip(plane.opposite());
        double sum = 0.0;
        for (const auto& part : {below, above}) {
            if (!part) continue;
            EXPECT_TRUE(part->is_consistent());
            sum += part->volume();
        }
        EXPECT_NEAR(sum, body->volume(), 1e-12 * body->volume());
    }
}

TEST(ClassifyBox, IsExactAtTheFaces) {
    const Box box{{0, 0, 0}, {10, 10, 10}};
    EXPECT_EQ(classify_box(box, {1, 0, 0, 10}), Side::Below);
    EXPECT_EQ(classify_box(box, {1, 0, 0, 9}), Side::On);
    EXPECT_EQ(classify_box(box, {1, 0, 0, 0}), Side::Above);
    EXPECT_EQ(classify_box(box, {1, 1, 1, std::int64_t{1} << 62}), Side::Below);
}

}  // namespace
}  // namespace ncsim::cda
