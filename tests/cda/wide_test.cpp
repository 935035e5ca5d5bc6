// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests functions of 128-bit integers.
#include "exact/wide.h"

#include "support/random.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

using test::Random;

// Returns a number of up to `bits` bits, often far fewer.
Int128 random_wide(Random& random, int bits) {
    const Int128 all = (static_cast<Int128>(random.next() >> 1) << 64) | random.next();
    const Int128 v = all >> (127 - random.between(1, bits));
    return random.one_in(2) ? v : -v;
}

TEST(Magnitude, OfTheLeastNumberIsNotNegative) {
    const Int128 least = static_cast<Int128>(static_cast<UInt128>(1) << 127);
    EXPECT_TRUE(magnitude(least) == static_cast<UInt128>(1) << 127);
    EXPECT_TRUE(magnitude(-5) == 5U);
    EXPECT_TRUE(magnitude(0) == 0U);
}

TEST(TrailingZeros, AreCountedInBothHalves) {
    for (int i = 0; i < 128; ++i)
        EXPECT_EQ(trailing_zeros(static_cast<UInt128>(1) << i), i);
    EXPECT_EQ(trailing_zeros(static_cast<UInt128>(3) << 70), 70);
}

TEST(Gcd, IsThatOfEuclid) {
    Random random(31);
    for (int i = 0; i < 20000; ++i) {
        const UInt128 a = magnitude(random_wide(random, 126));
        const UInt128 b = magnitude(random_wide(random, 126));
        UInt128 p = a;
        UInt128 q = b;
        while (q != 0) {
            const UInt128 rest = p % q;
            p = q;
            q = rest;
        }
        EXPECT_TRUE(gcd(a, b) == p);
    }
    EXPECT_TRUE(gcd(0, 0) == 0U);
    EXPECT_TRUE(gcd(0, 7) == 7U);
    EXPECT_TRUE(gcd(7, 0) == 7U);
}

TEST(FloorQuotient, IsTheLargestIntegerNotAbove) {
    EXPECT_TRUE(floor_quotient(-1, 3) == -1);
    EXPECT_TRUE(floor_quotient(-3, 3) == -1);
    EXPECT_TRUE(floor_quotient(2, 3) == 0);
    Random random(32);
    for (int i = 0; i < 20000; ++i) {
        const Int128 p = random_wide(random, 120);
        const Int128 q = static_cast<Int128>(magnitude(random_wide(random, 120))) + 1;
        const Int128 rest = p - floor_quotient(p, q) * q;
        EXPECT_TRUE(rest >= 0 && rest < q);
    }
}

}  // namespace
}  // namespace ncsim::cda
