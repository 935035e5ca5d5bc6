// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares verdicts on 100,000 random pairs of convex bodies with the Flexible Collision Library,
// which uses neither planes nor lattices. No verdict differs.
// Source: Pan, Chitta and Manocha, ICRA 2012.
#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/separation.h"

#include "support/random_shapes.h"

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

namespace ncsim::cda {
namespace {

using Points = std::vector<LatticePoint>;

struct Body {
    Points points;
    std::unique_ptr<fcl::Convexd> judged;  // in thousands of units
};

std::unique_ptr<fcl::Convexd> convex(const ConvexPolytope& body) {
    auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const ExactPoint& p : body.vertices())
        corners->emplace_back(1e-3 * p.approx.x, 1e-3 * p.approx.y, 1e-3 * p.approx.z);
    auto faces = std::make_shared<std::vector<int>>();
    for (const auto& facet : body.facets()) {
        faces->push_back(static_cast<int>(facet.vertices.size()));
        for (const std::uint32_t corner : facet.vertices)
            faces->push_back(static_cast<int>(corner));
    }
    return std::make_unique<fcl::Convexd>(corners, static_cast<int>(body.facets().size()), faces);
}

Body random_body(test::Random& random) {
    while (true) {
        Points points;
        const std::int64_t corners = random.between(4, 12);
        for (std::int64_t k = 0; k < corners; ++k)
            points.push_back(test::random_point(random, 40'000));
        const auto hull = convex_hull(points, test::kLattice, kStockOrigin);
        const auto body = hull ? ConvexPolytope::of(*hull, test::kLattice) : std::nullopt;
        if (body) return {std::move(points), convex(*body)};
    }
}

TEST(FclPairs, NoneOfAHundredThousandIsJudgedDifferently) {
    test::Random random(2026);
    std::vector<Body> bodies;
    for (int i = 0; i < 1000; ++i)
        bodies.push_back(random_body(random));
    constexpr int kPairs = 100'000;
    int apart = 0, different = 0, open = 0;
    const fcl::CollisionRequestd request;
    for (int i = 0; i < kPairs; ++i) {
        const Body& a = bodies[static_cast<std::size_t>(random.between(0, 999))];
        const Body& b = bodies[static_cast<std::size_t>(random.between(0, 999))];
        const LatticePoint way = test::random_point(random, 45'000);
        Points there = b.points;
        for (LatticePoint& p : there)
            p = p + way;
        fcl::Transform3d moved = fcl::Transform3d::Identity();
        moved.translation() << 1e-3 * static_cast<double>(way.x), 1e-3 * static_cast<double>(way.y),
            1e-3 * static_cast<double>(way.z);
        fcl::CollisionResultd result;
        fcl::collide(a.judged.get(), fcl::Transform3d::Identity(), b.judged.get(), moved, request,
                     result);
        const bool is_apart = body_distance(a.points, there, 0).is_apart;
        if (!is_apart && !common_point(a.points, there, 0)) ++open;
        if (is_apart == result.isCollision()) ++different;
        apart += is_apart ? 1 : 0;
    }
    EXPECT_EQ(different, 0);
    EXPECT_EQ(open, 0);
    EXPECT_GT(apart, kPairs / 4);
    EXPECT_LT(apart, 3 * kPairs / 4);
}

}  // namespace
}  // namespace ncsim::cda
