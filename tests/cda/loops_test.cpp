// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the orientation of loops, and whether a loop surrounds an edge.
#include "surface/loops.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace ncsim::cda {
namespace {

// Points of a coordinate plane, as multiples of 1 / w units.
struct Corners {
    std::vector<ExactPoint> all;
    LoopPoints points() const {
        return {[this](std::uint32_t i) { return all[i].approx; },
                [this](std::uint32_t i) { return all[i]; }};
    }
    void add(Int128 x, Int128 y, Int128 z, Int128 w) {
        const auto d = static_cast<double>(w);
        all.push_back(
            {x,
             y,
             z,
             w,
             {static_cast<double>(x) / d, static_cast<double>(y) / d, static_cast<double>(z) / d}});
    }
};

constexpr Plane kUp{0, 0, 1, 0};

TEST(Loops, KnowTheirOrientationFromBothSidesOfThePlane) {
    Corners c;
    c.add(0, 0, 0, 1), c.add(10, 0, 0, 1), c.add(10, 10, 0, 1), c.add(0, 10, 0, 1);
    const std::vector<std::uint32_t> loop{0, 1, 2, 3};
    const std::vector<std::uint32_t> reversed{3, 2, 1, 0};
    EXPECT_EQ(orientation(loop, kUp, c.points()), 1);
    EXPECT_EQ(orientation(reversed, kUp, c.points()), -1);
    EXPECT_EQ(orientation(loop, kUp.opposite(), c.points()), -1);
    EXPECT_EQ(orientation(std::vector<std::uint32_t>{0, 1, 0, 1}, kUp, c.points()), 0);
    // Views along x and along y.
    Corners d;
    d.add(0, 0, 0, 1), d.add(0, 10, 0, 1), d.add(0, 10, 10, 1);
    EXPECT_EQ(orientation(std::vector<std::uint32_t>{0, 1, 2}, {1, 0, 0, 0}, d.points()), 1);
    Corners e;
    e.add(0, 0, 0, 1), e.add(0, 0, 10, 1), e.add(10, 0, 10, 1);
    EXPECT_EQ(orientation(std::vector<std::uint32_t>{0, 1, 2}, {0, 1, 0, 0}, e.points()), 1);
}

TEST(Loops, OfWhichDoublesSeeNothingAreLeftToIntegers) {
    // A loop 2^-40 of a unit wide, far from the origin.
    constexpr Int128 w = Int128{1} << 40;
    constexpr Int128 far = 30'000'000;
    Corners c;
    c.add(far * w, far * w, 0, w);
    c.add(far * w + 1, far * w, 0, w);
    c.add(far * w + 1, far * w + 1, 0, w);
    c.add(far * w, far * w + 1, 0, w);
    const std::vector<std::uint32_t> loop{0, 1, 2, 3};
    ASSERT_EQ(c.all[0].approx, c.all[2].approx);
    EXPECT_EQ(orientation(loop, kUp, c.points()), 1);
    EXPECT_EQ(orientation(std::vector<std::uint32_t>{3, 2, 1, 0}, kUp, c.points()), -1);
    EXPECT_TRUE(surrounds(loop, 0, 2, kUp, c.points()));
    // Points as little outside the loop.
    c.add(far * w + 2, far * w, 0, w);
    c.add(far * w + 2, far * w + 1, 0, w);
    EXPECT_FALSE(surrounds(loop, 4, 5, kUp, c.points()));
    EXPECT_FALSE(surrounds(loop, 1, 5, kUp, c.points()));
}

TEST(Loops, SurroundWhatIsInside) {
    // A C-shaped loop: (15, 5) and (5, 15) are inside, (15, 15) is not.
    Corners c;
    c.add(0, 0, 0, 1), c.add(30, 0, 0, 1), c.add(30, 10, 0, 1), c.add(10, 10, 0, 1);
    c.add(10, 20, 0, 1), c.add(30, 20, 0, 1), c.add(30, 30, 0, 1), c.add(0, 30, 0, 1);
    std::vector<std::uint32_t> loop(8);
    std::iota(loop.begin(), loop.end(), 0U);
    const auto inside = [&](std::int64_t x, std::int64_t y) {
        const auto at = static_cast<std::uint32_t>(c.all.size());
        c.add(2 * x - 1, 2 * y, 0, 2), c.add(2 * x + 1, 2 * y, 0, 2);
        return surrounds(loop, at, at + 1, kUp, c.points());
    };
    for (std::int64_t y : {1, 5, 9})
        EXPECT_TRUE(inside(15, y)) << y;
    EXPECT_TRUE(inside(5, 15));
    EXPECT_TRUE(inside(5, 10));  // as high as a corner
    EXPECT_TRUE(inside(5, 20));
    EXPECT_FALSE(inside(15, 15));
    EXPECT_FALSE(inside(40, 5));
    EXPECT_FALSE(inside(-5, 10));
    EXPECT_FALSE(inside(5, 40));
}

}  // namespace
}  // namespace ncsim::cda
