// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/base/mix.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace ncsim {
namespace {

// Source: the first numbers of splitmix64 with state 0.
TEST(Mix, IsTheFinalizerOfSplitmix64) {
    EXPECT_EQ(mix(0, 0), 0xe220a8397b1dcdafU);
    EXPECT_EQ(mix(0x9e3779b97f4a7c15U, 0), 0x6e789e6aa1b965f4U);
    EXPECT_EQ(mix(2 * 0x9e3779b97f4a7c15U, 0), 0x06c45d188009454fU);
    static_assert(mix(5, 9) == mix(9, 5), "an exclusive or begins the hash");
}

TEST(Mix, ChangesHalfOfTheBitsForEachBit) {
    int changed = 0;
    for (unsigned bit = 0; bit < 64; ++bit) {
        const int bits = std::popcount(mix(1, 7) ^ mix(1, 7 ^ (std::uint64_t{1} << bit)));
        EXPECT_GE(bits, 14) << bit;
        EXPECT_LE(bits, 50) << bit;
        changed += bits;
    }
    EXPECT_NEAR(changed / 64.0, 32.0, 2.0);
}

}  // namespace
}  // namespace ncsim
