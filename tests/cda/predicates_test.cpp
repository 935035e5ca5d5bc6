// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/predicates.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

using test::Random;

Plane random_plane(Random& random) {
    constexpr std::int64_t n = std::int64_t{1} << kNormalBits;
    constexpr std::int64_t c = std::int64_t{1} << kCoordinateBits;
    while (true) {
        const auto p = test::random_point(random, n);
        if (p == LatticePoint{}) continue;
        // Through a random point of the range, so that the plane meets it.
        const auto q = test::random_point(random, c);
        return canonical(p.x, p.y, p.z, p.x * q.x + p.y * q.y + p.z * q.z);
    }
}

bool in_range(const ExactPoint& p) {
    constexpr double c = static_cast<double>(std::int64_t{1} << kCoordinateBits);
    return std::abs(p.approx.x) <= c && std::abs(p.approx.y) <= c && std::abs(p.approx.z) <= c;
}

TEST(Meet, ThreeAxisPlanesMeetInTheLatticePoint) {
    const auto p = meet({1, 0, 0, 3}, {0, 1, 0, 5}, {0, 0, 1, -7});
    ASSERT_TRUE(p);
    EXPECT_TRUE(same_point(reduced(*p), ExactPoint::at({3, 5, -7})));
    EXPECT_EQ(p->approx, (Vec3{3, 5, -7}));
}

TEST(Meet, PlanesThroughOneLineMeetInNoPoint) {
    EXPECT_FALSE(meet({1, 0, 0, 3}, {0, 1, 0, 5}, {1, 1, 0, 8}));
    EXPECT_FALSE(meet({1, 0, 0, 3}, {1, 0, 0, 4}, {0, 0, 1, 0}));
}

TEST(Classify, APointIsOnThePlanesThatMadeIt) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Plane a = random_plane(random);
        const Plane b = random_plane(random);
        const Plane c = random_plane(random);
        const auto p = meet(a, b, c);
        if (!p || !in_range(*p)) continue;
        EXPECT_EQ(classify(*p, a), Side::On);
        EXPECT_EQ(classify(*p, b), Side::On);
        EXPECT_EQ(classify(*p, c), Side::On);
        const Plane h = random_plane(random);
        EXPECT_EQ(classify(*p, h), classify_exact(*p, h));
        EXPECT_EQ(classify(*p, h), opposite(classify(*p, h.opposite())));
    }
}

TEST(Classify, TellsPlanesApartThatAreOneUnitOfDistanceApart) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Plane a = random_plane(random);
        const Plane b = random_plane(random);
        const Plane c = random_plane(random);
        const auto p = meet(a, b, c);
        if (!p || !in_range(*p)) continue;
        Plane above = a;
        above.d += 1;
        Plane below = a;
        below.d -= 1;
        EXPECT_EQ(classify(*p, above), Side::Below);
        EXPECT_EQ(classify(*p, below), Side::Above);
    }
}

TEST(Reduced, MakesThePointIndependentOfThePlanesThatMadeIt) {
    const auto p = meet({3, 1, 0, 30}, {0, 1, 0, 0}, {0, 0, 1, 7});
    const auto q = meet({1, 0, 0, 10}, {0, 2, 2, 14}, {0, 3, 1, 7});
    ASSERT_TRUE(p && q);
    EXPECT_TRUE(same_point(reduced(*p), reduced(*q)));
}

TEST(OrderAlong, FollowsTheDirectionOfTheTwoNormals) {
    // x × y = z: upwards.
    const Plane x{1, 0, 0, 0};
    const Plane y{0, 1, 0, 0};
    const ExactPoint low = ExactPoint::at({0, 0, 1});
    EXPECT_EQ(order_along(x, y, low, {0, 0, 1, 2}), Side::Below);
    EXPECT_EQ(order_along(x, y, low, {0, 0, -1, -2}), Side::Below);
    EXPECT_EQ(order_along(y, x, low, {0, 0, 1, 2}), Side::Above);
    EXPECT_EQ(order_along(x, y, low, {1, 1, 1, 1}), Side::On);
}

}  // namespace
}  // namespace ncsim::cda
