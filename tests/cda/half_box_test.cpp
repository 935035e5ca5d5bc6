// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests boxes in half units, and the sides of planes on which boxes lie.
#include "exact/half_box.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ncsim::cda {
namespace {

using test::Random;

HalfBox random_box(Random& random, std::int64_t reach, std::int64_t size) {
    HalfBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        box.min[i] = 2 * random.between(-reach, reach) + 1;
        box.max[i] = box.min[i] + 2 * random.between(2, size);
    }
    return box;
}

TEST(HalfBox, HalvesMeetAtAnOddNumberAndFillIt) {
    Random random(61);
    for (int i = 0; i < 10000; ++i) {
        const HalfBox box = random_box(random, 1 << 24, random.one_in(2) ? 5 : 1 << 20);
        const std::size_t axis = box.longest_axis();
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_GE(box.extent(axis), box.extent(k));
        const HalfBox low = box.half(axis, false);
        const HalfBox high = box.half(axis, true);
        EXPECT_EQ(std::abs(low.max[axis] % 2), 1);
        EXPECT_EQ(low.max[axis], high.min[axis]);
        EXPECT_FALSE(low.is_empty() || high.is_empty());
        EXPECT_EQ(enclosing(low, high), box);
        EXPECT_TRUE(intersection(low, high).is_empty());
        EXPECT_EQ(intersection(box, low), low);
        EXPECT_LE(std::abs(low.extent(axis) - high.extent(axis)), 2);
    }
}

TEST(HalfBox, HasNothingInCommonWithOneBesideIt) {
    const HalfBox box{{1, 1, 1}, {5, 5, 5}};
    EXPECT_TRUE(intersection(box, {{5, 1, 1}, {9, 5, 5}}).is_empty());
    EXPECT_FALSE(intersection(box, {{3, 3, 3}, {9, 9, 9}}).is_empty());
}

// Compares with all eight corners, in integers.
TEST(BoxHeight, TellsWhereABoxLies) {
    Random random(62);
    int touching = 0;
    for (int i = 0; i < 50000; ++i) {
        const HalfBox box = random_box(random, (1 << 24) - (1 << 20), 1 << 20);
        Plane plane = test::random_normal(random, random.one_in(2) ? 2 : 1 << kNormalBits);
        // The plane passes through a corner or near a corner.
        const auto corner = [&](unsigned bits, std::size_t axis) {
            return (bits >> axis & 1U) != 0 ? box.max[axis] : box.min[axis];
        };
        const auto along = [&](unsigned bits) {
            return static_cast<Int128>(plane.nx) * corner(bits, 0) +
                   static_cast<Int128>(plane.ny) * corner(bits, 1) +
                   static_cast<Int128>(plane.nz) * corner(bits, 2);
        };
        plane.d = static_cast<std::int64_t>(along(static_cast<unsigned>(random.between(0, 7))) / 2);
        plane.d += random.between(-1, 1);
        Int128 low = along(0);
        Int128 high = low;
        for (unsigned bits = 1; bits < 8; ++bits) {
            low = std::min(low, along(bits));
            high = std::max(high, along(bits));
        }
        const Int128 d2 = 2 * static_cast<Int128>(plane.d);
        const Side expected = high <= d2 ? Side::Below : low >= d2 ? Side::Above : Side::On;
        EXPECT_EQ(side_of(BoxFrame(box), HalfPlane(plane)), expected);
        touching += high == d2 || low == d2 ? 1 : 0;
    }
    EXPECT_GT(touching, 1000);
}

}  // namespace
}  // namespace ncsim::cda
