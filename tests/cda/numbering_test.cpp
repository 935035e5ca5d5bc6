// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests Plücker coordinates of the lines in which planes meet.
#include "exact/numbering.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

using test::Random;

// Returns a plane through the line of s and t.
Plane turned_about(const Plane& s, const Plane& t, std::int64_t a, std::int64_t b) {
    return canonical(a * s.nx + b * t.nx, a * s.ny + b * t.ny, a * s.nz + b * t.nz,
                     a * s.d + b * t.d);
}

Plane random_plane(Random& random, std::int64_t size) {
    const Plane n = test::random_normal(random, size);
    return canonical(n.nx, n.ny, n.nz, random.between(-(std::int64_t{1} << 40), 1LL << 40));
}

TEST(Pluecker, IsOneForAllPlanesThroughTheLine) {
    Random random(51);
    for (int i = 0; i < 20000; ++i) {
        const Plane s = random_plane(random, random.one_in(2) ? 3 : 1 << 18);
        const Plane t = random_plane(random, random.one_in(2) ? 3 : 1 << 18);
        if (s.is_parallel_to(t)) continue;
        const Plane u = turned_about(s, t, random.between(1, 9), random.between(1, 9));
        const Plane v = turned_about(s, t, random.between(1, 9), -random.between(1, 9));
        const Pluecker line(s, t);
        for (const Pluecker& other :
             {Pluecker(t, s), Pluecker(s.opposite(), t), Pluecker(u, s), Pluecker(v, u)}) {
            EXPECT_TRUE(are_same(line, other));
            EXPECT_TRUE(are_same(other, line));
            EXPECT_EQ(line.hash(), other.hash());
        }
        // Shifts the plane by the least amount, and turns the plane by the least amount.
        Plane beside = t;
        beside.d += 1;
        EXPECT_FALSE(are_same(line, Pluecker(s, beside)));
        Plane turned = t;
        turned.nx += 1;
        if (!s.is_parallel_to(turned) && turn(s, t, turned) != 0) {
            EXPECT_FALSE(are_same(line, Pluecker(s, turned)));
        }
    }
}

TEST(Pluecker, OfLinesAlongTheAxes) {
    const Pluecker z({1, 0, 0, 3}, {0, 1, 0, 5});
    EXPECT_EQ(z.d, (std::array<std::int64_t, 3>{0, 0, 1}));
    EXPECT_EQ(longest(z.d), 2U);
    EXPECT_EQ(longest({-4, 4, 3}), 0U);
    EXPECT_TRUE(are_same(z, Pluecker({1, 1, 0, 8}, {1, -1, 0, -2})));
    EXPECT_FALSE(are_same(z, Pluecker({1, 0, 0, 5}, {0, 1, 0, 3})));
}

}  // namespace
}  // namespace ncsim::cda
