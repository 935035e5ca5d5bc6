// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests exact predicates against integers of any size and against each other.
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
        // The plane passes through a random point of the range, so it meets the range.
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

// Three planes that meet in a point of the range, and a fourth plane.
struct Four {
    Plane a, b, c, h;
    ExactPoint p;
};

// Returns planes of any size, or planes of a few bits close to a common point, where doubles cannot
// decide.
Four random_four(Random& random) {
    while (true) {
        Four f;
        const bool is_close = random.one_in(2);
        const std::int64_t size = std::int64_t{1}
                                  << (is_close ? random.between(1, 6) : kNormalBits);
        const auto at = test::random_point(random, std::int64_t{1} << kCoordinateBits);
        for (Plane* plane : {&f.a, &f.b, &f.c, &f.h}) {
            *plane = random_plane(random);
            if (!is_close) continue;
            const Plane n = test::random_normal(random, size);
            *plane = canonical(n.nx, n.ny, n.nz,
                               n.nx * at.x + n.ny * at.y + n.nz * at.z +
                                   (random.one_in(3) ? random.between(-1, 1) : 0));
        }
        const auto p = meet(f.a, f.b, f.c);
        if (!p || !in_range(*p)) continue;
        f.p = *p;
        return f;
    }
}

constexpr int kMany = 20000;

TEST(Meet, HasTheSameNumbersInAnyOrderAndForOpposites) {
    Random random(21);
    for (int i = 0; i < kMany; ++i) {
        const Four f = random_four(random);
        for (const auto& p :
             {meet(f.b, f.a, f.c), meet(f.c, f.b, f.a), meet(f.b, f.c, f.a),
              meet(f.a.opposite(), f.b, f.c), meet(f.a, f.c.opposite(), f.b.opposite())}) {
            ASSERT_TRUE(p);
            EXPECT_TRUE(same_point(*p, f.p));
            EXPECT_EQ(p->approx, f.p.approx);
        }
        const auto bare = meet_exactly(f.a, f.b, f.c);
        ASSERT_TRUE(bare);
        EXPECT_TRUE(same_point(*bare, f.p));
    }
}

TEST(Meet, IsNothingWhereNothingTurns) {
    Random random(22);
    int nothing = 0;
    for (int i = 0; i < kMany; ++i) {
        const Plane a = test::random_normal(random, 2);
        const Plane b = test::random_normal(random, 2);
        const Plane c = test::random_normal(random, 2);
        EXPECT_EQ(meet(a, b, c).has_value(), turn(a, b, c) != 0);
        nothing += turn(a, b, c) == 0 ? 1 : 0;
    }
    EXPECT_GT(nothing, 1000);
}

TEST(Classify, DependsOnThePointAlone) {
    Random random(23);
    for (int i = 0; i < kMany; ++i) {
        const Four f = random_four(random);
        EXPECT_EQ(classify(reduced(f.p), f.h), classify(f.p, f.h));
    }
}

TEST(Classify, InDoublesIsRightOrSilent) {
    Random random(24);
    int silent = 0;
    for (int i = 0; i < kMany; ++i) {
        const Four f = random_four(random);
        const auto specified = classify_in_doubles(f.p, f.h);
        silent += specified ? 0 : 1;
        if (specified) {
            EXPECT_EQ(*specified, classify_exact(f.p, f.h));
        }
        EXPECT_FALSE(classify_in_doubles(f.p, f.a));
    }
    EXPECT_GT(silent, 1000);
    EXPECT_LT(silent, kMany - 1000);
}

TEST(Turn, IsCyclicAndChangesItsSignWithAnyTwo) {
    Random random(25);
    for (int i = 0; i < kMany; ++i) {
        const std::int64_t size = random.one_in(2) ? 2 : std::int64_t{1} << kNormalBits;
        const Plane s = test::random_normal(random, size);
        const Plane t = test::random_normal(random, size);
        const Plane h = test::random_normal(random, size);
        EXPECT_EQ(turn(s, t, h), turn(t, h, s));
        EXPECT_EQ(turn(s, t, h), -turn(t, s, h));
        EXPECT_EQ(turn(s, t, h), -turn(s, t, h.opposite()));
    }
}

TEST(CompareCoordinate, IsAnOrderOfPoints) {
    Random random(26);
    int equal = 0;
    for (int i = 0; i < kMany; ++i) {
        const Four f = random_four(random);
        const auto other = meet(f.a, f.b, f.h);
        const auto third = meet(f.a, f.c, f.h);
        if (!other || !in_range(*other) || !third || !in_range(*third)) continue;
        bool is_one = true;
        for (int axis = 0; axis < 3; ++axis) {
            const int order = compare_coordinate(f.p, *other, axis);
            EXPECT_EQ(order, compare_coordinate_exact(f.p, *other, axis));
            EXPECT_EQ(order, -compare_coordinate(*other, f.p, axis));
            const int next = compare_coordinate(*other, *third, axis);
            if (order * next >= 0 && order + next != 0) {
                EXPECT_EQ(compare_coordinate(f.p, *third, axis), order != 0 ? order : next);
            }
            is_one &= order == 0;
        }
        EXPECT_EQ(is_one, same_point(reduced(f.p), reduced(*other)));
        EXPECT_EQ(is_one, classify(f.p, f.h) == Side::On);
        equal += is_one ? 1 : 0;
    }
    EXPECT_GT(equal, 500);
}

TEST(CompareCoordinate, TellsPointsApartThatDoublesDoNot) {
    // 1/3 of a unit, and a slightly larger coordinate: by 2^20 / (3 · 2^80) of a unit.
    ExactPoint a;
    a.x = Int128{1} << 80;
    a.w = 3 * (Int128{1} << 80);
    ExactPoint b = a;
    b.x += 1 << 20;
    a.approx.x = b.approx.x = 1.0 / 3.0;
    EXPECT_EQ(compare_coordinate(a, b, 0), -1);
    EXPECT_EQ(compare_coordinate(b, a, 0), 1);
    EXPECT_EQ(compare_coordinate(a, a, 0), 0);
    EXPECT_EQ(compare_coordinate(a, b, 1), 0);
}

// Compares parallel planes at equal and different distances.
TEST(CompareDistances, IsAnOrderOfParallelPlanes) {
    Random random(27);
    for (int i = 0; i < kMany; ++i) {
        const Plane n = test::random_normal(random, 1 << 20);
        const auto moved = [&] {
            const std::int64_t times = random.between(1, 3);
            return canonical(times * n.nx, times * n.ny, times * n.nz, random.between(-4, 4));
        };
        const Plane a = moved();
        const Plane b = moved();
        const Plane c = moved();
        const int order = compare_distances(a, b);
        EXPECT_EQ(order, -compare_distances(b, a));
        EXPECT_EQ(order == 0, a == b);
        if (order == compare_distances(b, c)) {
            EXPECT_EQ(compare_distances(a, c), order);
        }
        // A point of a is below b if b is beyond a.
        const std::size_t axis = n.nx != 0 ? 0 : n.ny != 0 ? 1 : 2;
        const Plane u = axis == 0 ? Plane{0, 1, 0, 0} : Plane{1, 0, 0, 0};
        const Plane v = axis == 2 ? Plane{0, 1, 0, 0} : Plane{0, 0, 1, 0};
        const auto p = meet(a, u, v);
        ASSERT_TRUE(p);
        EXPECT_EQ(static_cast<int>(classify_exact(*p, b)), -order);
        EXPECT_TRUE(same_direction(a, b));
        EXPECT_FALSE(same_direction(a, b.opposite()));
        EXPECT_EQ(distance_beyond(a, b, true), order);
        EXPECT_EQ(distance_beyond(a, b, true), -distance_beyond(a, b.opposite(), false));
        EXPECT_EQ(distance_beyond(a, b.opposite(), false),
                  -static_cast<int>(classify_exact(*p, b.opposite())));
    }
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

// Planes of few bits, like the planes of tools, through a point or a few units of distance from the
// point.
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

// Compares with the same determinants in integers of any size, with every bit of the budget in use.
TEST(Exactness, AgreesWithWiderIntegersAtTheLimits) {
    Random random(5);
    const auto det = [](const Plane& p, const Plane& q, const Plane& r, int with_d) {
        // Rows (nx, ny, nz), with a column replaced by d.
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
        // Every second plane has the largest possible components.
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

TEST(OrderAlong, IsAnOrderOfPointsOfTheLine) {
    Random random(28);
    int equal = 0;
    for (int i = 0; i < kMany; ++i) {
        // a and b are on the line of f.a and f.b, where f.c and f.h meet the line.
        const Four f = random_four(random);
        const auto b = meet(f.a, f.b, f.h);
        if (!b || !in_range(*b)) continue;
        const Side order = order_along(f.a, f.b, f.p, f.h);
        EXPECT_EQ(order_along(f.b, f.a, f.p, f.h), opposite(order));
        EXPECT_EQ(order_along(f.a, f.b, f.p, f.h.opposite()), order);
        EXPECT_EQ(order_along(f.a, f.b, *b, f.c), opposite(order));
        equal += order == Side::On ? 1 : 0;
    }
    EXPECT_GT(equal, 500);
}

}  // namespace
}  // namespace ncsim::cda
