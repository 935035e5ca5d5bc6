// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/predicates.h"

#include "support/random_shapes.h"

#include <gmpxx.h>
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

// Planes of few bits, as those of tools, through a point or a few units of distance beside it.
TEST(Classify, IsTheSameForPointsThatAreKnownToBeNear) {
    Random random(3);
    int in_64_bits = 0;
    int on = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t size = std::int64_t{1} << random.between(1, kNormalBits);
        const auto at = test::random_point(random, std::int64_t{1} << kCoordinateBits);
        const auto plane_near = [&] {
            LatticePoint n;
            while (n == LatticePoint{})
                n = test::random_point(random, size);
            Plane plane = canonical(n.x, n.y, n.z, n.x * at.x + n.y * at.y + n.z * at.z);
            if (random.one_in(3)) plane.d += random.between(-3, 3);
            return plane;
        };
        const Plane a = plane_near();
        const Plane b = plane_near();
        const Plane c = plane_near();
        const Plane h = plane_near();
        const auto p = meet(a, b, c);
        if (!p || !in_range(*p)) continue;
        const double height = std::abs(p->approx.x * h.nx + p->approx.y * h.ny +
                                       p->approx.z * h.nz - static_cast<double>(h.d));
        const double most = 2.0 * height + 16.0;
        const Side side = classify_exact(*p, h);
        EXPECT_EQ(classify_near(a, b, c, h, most), side);
        EXPECT_EQ(classify_near(a, b, c, h.opposite(), most), opposite(side));
        in_64_bits += static_cast<double>(p->w) * most < 0x1p58 ? 1 : 0;
        on += side == Side::On ? 1 : 0;
    }
    EXPECT_GT(in_64_bits, 5000);
    EXPECT_GT(on, 2000);
}

TEST(Reduced, MakesThePointIndependentOfThePlanesThatMadeIt) {
    const auto p = meet({3, 1, 0, 30}, {0, 1, 0, 0}, {0, 0, 1, 7});
    const auto q = meet({1, 0, 0, 10}, {0, 2, 2, 14}, {0, 3, 1, 7});
    ASSERT_TRUE(p && q);
    EXPECT_TRUE(same_point(reduced(*p), reduced(*q)));
}

mpz_class wide(Int128 v) {
    const bool is_negative = v < 0;
    mpz_class result = 0;
    for (int shift = 96; shift >= 0; shift -= 32) {
        const Int128 word = (v >> shift) & 0xffffffff;
        result = (result << 32) + static_cast<unsigned long>(word);
    }
    return is_negative ? mpz_class(result - (mpz_class(1) << 128)) : result;
}

// The same determinants in integers of any size, with every bit of the budget in use.
TEST(Exactness, AgreesWithWiderIntegersAtTheLimits) {
    Random random(5);
    const auto det = [](const Plane& p, const Plane& q, const Plane& r, int with_d) {
        // Rows (nx, ny, nz), one column replaced by d.
        mpz_class m[3][3];
        int row = 0;
        for (const Plane& plane : {p, q, r}) {
            const long n[3] = {plane.nx, plane.ny, plane.nz};
            for (int k = 0; k < 3; ++k)
                m[row][k] = k == with_d ? static_cast<long>(plane.d) : n[k];
            ++row;
        }
        return mpz_class(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
    };
    int at_limits = 0;
    for (int i = 0; i < 200000; ++i) {
        // Every other plane with the largest components there are.
        const auto plane = [&] {
            Plane p = random_plane(random);
            if (random.between(0, 1) == 0) return p;
            constexpr std::int64_t n = std::int64_t{1} << kNormalBits;
            constexpr std::int64_t c = std::int64_t{1} << kCoordinateBits;
            const auto end = [&](std::int64_t limit) {
                return (random.between(0, 1) == 0 ? -1 : 1) * (limit - random.between(0, 1));
            };
            const std::int64_t x = end(n), y = end(n), z = end(n);
            return canonical(x, y, z, x * end(c) + y * end(c) + z * end(c));
        };
        const Plane p = plane(), q = plane(), r = plane(), h = plane();
        const auto point = meet(p, q, r);
        const mpz_class w = det(p, q, r, 3);
        ASSERT_EQ(point.has_value(), w != 0);
        if (!point || !in_range(*point)) continue;
        ++at_limits;
        const int sign = sgn(w);
        const mpz_class x = sign * det(p, q, r, 0);
        const mpz_class y = sign * det(p, q, r, 1);
        const mpz_class z = sign * det(p, q, r, 2);
        ASSERT_EQ(wide(point->x), x);
        ASSERT_EQ(wide(point->y), y);
        ASSERT_EQ(wide(point->z), z);
        ASSERT_EQ(wide(point->w), mpz_class(abs(w)));
        const mpz_class height = x * static_cast<long>(h.nx) + y * static_cast<long>(h.ny) +
                                 z * static_cast<long>(h.nz) - abs(w) * static_cast<long>(h.d);
        ASSERT_EQ(static_cast<int>(classify_exact(*point, h)), sgn(height));
        ASSERT_EQ(static_cast<int>(classify(*point, h)), sgn(height));
    }
    EXPECT_GT(at_limits, 20000);
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
