// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests vectors of the plane.
#include "ncsim/base/vec2.h"

#include <gtest/gtest.h>

namespace ncsim {
namespace {

TEST(Vec2, TheCrossProductIsPositiveToTheLeft) {
    EXPECT_EQ(cross({2, 0}, {1, 3}), 6.0);
    EXPECT_EQ(cross({1, 3}, {2, 0}), -6.0);
    EXPECT_GT(cross({3, -4}, left_normal({3, -4})), 0.0);
    EXPECT_EQ(dot({3, -4}, left_normal({3, -4})), 0.0);
}

TEST(Vec2, NormalizedHasLengthOneAndZeroStaysZero) {
    const Vec2 n = normalized(Vec2{3, -4});
    EXPECT_DOUBLE_EQ(n[0], 0.6);
    EXPECT_DOUBLE_EQ(n[1], -0.8);
    EXPECT_EQ(norm({3, -4}), 5.0);
    EXPECT_EQ(normalized(Vec2{}), Vec2{});
}

}  // namespace
}  // namespace ncsim
