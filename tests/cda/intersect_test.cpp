// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests linear programs, and intersections of convex polytopes.
#include "ncsim/cda/intersect.h"

#include "polytope/linear_program.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

ConvexPolytope polytope(const Cell& cell) {
    return *ConvexPolytope::of(cell, kLattice);
}

TEST(LinearProgram, ACornerOfTheStartBoxIsOptimalWithoutHalfspaces) {
    const auto p = farthest_point({}, {{0, 0, 0}, {1, 2, 3}}, {1, 1, 1}, 1);
    ASSERT_TRUE(p);
    EXPECT_EQ(*p, (Vec3{1, 2, 3}));
}

TEST(LinearProgram, GoesDownToThePlaneAndToTheLine) {
    const std::vector<Halfspace> cuts{{{0, 0, 1}, 0.5}, {{0, 1, 0}, 0.25}, {{1, 0, 0}, 0.75}};
    const auto p = farthest_point(cuts, {{0, 0, 0}, {1, 1, 1}}, {1, 1, 1}, 7);
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->x, 0.75, 1e-12);
    EXPECT_NEAR(p->y, 0.25, 1e-12);
    EXPECT_NEAR(p->z, 0.5, 1e-12);
}

TEST(LinearProgram, ContradictionsHaveNoPoint) {
    const std::vector<Halfspace> cuts{{{0, 0, 1}, 0.25}, {{0, 0, -1}, -0.75}};
    EXPECT_FALSE(farthest_point(cuts, {{0, 0, 0}, {1, 1, 1}}, {1, 1, 1}, 1));
}

TEST(LinearProgram, TheOptimumDoesNotDependOnTheOrder) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        std::vector<Halfspace> cuts;
        for (int k = 0; k < 40; ++k) {
            const auto n = test::random_point(random, 1000);
            const Vec3 normal = normalized(
                {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)});
            cuts.push_back({normal, 1.0 + 0.01 * k});
        }
        const Box box{{-5, -5, -5}, {5, 5, 5}};
        const Vec3 objective{0.5, 0.7, 0.3};
        const auto p = farthest_point(cuts, box, objective, 1);
        const auto q = farthest_point(cuts, box, objective, 2);
        ASSERT_TRUE(p && q);
        EXPECT_NEAR(dot(objective, *p), dot(objective, *q), 1e-9);
        for (const Halfspace& h : cuts)
            EXPECT_LE(dot(h.normal, *p), h.distance + 1e-9);
    }
}

TEST(InteriorPoint, OfABoxIsInside) {
    const auto p = interior_point({}, {{0, 0, 0}, {2, 2, 2}}, 1);
    ASSERT_TRUE(p);
    EXPECT_TRUE((Box{{0.1, 0.1, 0.1}, {1.9, 1.9, 1.9}}.contains(*p)));
}

TEST(Intersect, TwoBoxesThatOverlapInABox) {
    IntersectionCosts costs;
    const auto c =
        intersect(polytope(mm_box(0, 0, 0, 2, 2, 2)), polytope(mm_box(1, 1, 1, 3, 3, 3)), costs);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->volume(), 1e15);
    EXPECT_EQ(c->facets().size(), 6U);
    EXPECT_EQ(costs.exact_fallbacks, 0U);
}

TEST(Intersect, TouchingBoxesHaveNoVolumeInCommon) {
    IntersectionCosts costs;
    const auto a = polytope(mm_box(0, 0, 0, 1, 1, 1));
    EXPECT_FALSE(intersect(a, polytope(mm_box(1, 0, 0, 2, 1, 1)), costs));
    EXPECT_FALSE(intersect(a, polytope(mm_box(1, 1, 1, 2, 2, 2)), costs));
    EXPECT_FALSE(intersect(a, polytope(mm_box(5, 5, 5, 6, 6, 6)), costs));
}

TEST(Intersect, AnOverlapOfOneUnitIsFound) {
    // 10 nm is far below any epsilon that is safe in doubles (thesis 4.3: 1e-3 to 1e-2).
    IntersectionCosts costs;
    const auto a = polytope(mm_box(0, 0, 0, 1, 1, 1));
    const auto b = polytope(box_cell({99999, 0, 0}, {200000, 100000, 100000}, kLattice));
    const auto c = intersect(a, b, costs);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->volume(), 1e10);
}

// Compares the fast algorithm with cutting plane by plane.
TEST(Intersect, AgreesWithCuttingPlaneByPlane) {
    Random random(11);
    int proven = 0;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const auto a = polytope(test::random_hull(random, {}, 500000, 40));
        const auto b =
            polytope(test::random_hull(random, test::random_point(random, 400000), 500000, 40));
        IntersectionCosts costs;
        const auto c = intersect(a, b, costs);
        const auto d = intersect_exact(a, b);
        ASSERT_EQ(c.has_value(), d.has_value());
        if (!c) continue;
        EXPECT_TRUE(c->is_consistent());
        ASSERT_EQ(c->facets().size(), d->facets().size());
        ASSERT_EQ(c->vertices().size(), d->vertices().size());
        EXPECT_NEAR(c->volume(), d->volume(), 1e-10 * d->volume());
        if (costs.exact_fallbacks == 0) ++proven;
    }
    // Doubles are good enough for bodies in general position; the fallback is for the rest.
    EXPECT_GT(proven, 200);
}

TEST(CommonPoint, IsInsideBothBodies) {
    const auto p =
        common_point(polytope(mm_box(0, 0, 0, 2, 2, 2)), polytope(mm_box(1, 1, 1, 3, 3, 3)));
    ASSERT_TRUE(p);
    EXPECT_TRUE((Box{{100000, 100000, 100000}, {200000, 200000, 200000}}.contains(*p)));
    EXPECT_FALSE(
        common_point(polytope(mm_box(0, 0, 0, 1, 1, 1)), polytope(mm_box(1, 0, 0, 2, 1, 1))));
}

}  // namespace
}  // namespace ncsim::cda
