// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests intervals of rays, packed normals and axes of the grid.
#include "rays.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::dexel {
namespace {

End end_at(std::int32_t at, std::uint32_t motion) {
    End end;
    end.at = at;
    end.origin = cda::Origin{motion};
    return end;
}

// Slow oracle: stores each unit of a short ray separately.
class UnitByUnit {
public:
    static constexpr std::int32_t kLength = 60;

    UnitByUnit() { in_.fill(true); }
    void cut(std::int32_t low, std::int32_t high) {
        for (std::int32_t i = std::max(low, 0); i < std::min(high, kLength); ++i)
            in_[static_cast<std::size_t>(i)] = false;
    }
    std::vector<std::array<std::int32_t, 2>> intervals() const {
        std::vector<std::array<std::int32_t, 2>> found;
        for (std::int32_t i = 0; i < kLength; ++i) {
            if (!in(i)) continue;
            if (i == 0 || !in(i - 1)) found.push_back({i, i + 1});
            found.back()[1] = i + 1;
        }
        return found;
    }
    bool in(std::int32_t i) const {
        return i >= 0 && i < kLength && in_[static_cast<std::size_t>(i)];
    }

private:
    std::array<bool, kLength> in_{};
};

TEST(Ray, HasWhatIsLeftUnitByUnit) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Ray ray;
        ray.set({end_at(0, 0), end_at(UnitByUnit::kLength, 0)});
        UnitByUnit slow;
        for (std::uint32_t motion = 1; motion < 30; ++motion) {
            const auto low = static_cast<std::int32_t>(random.next() % 70) - 5;
            const auto high = low + 1 + static_cast<std::int32_t>(random.next() % 8);
            const Gap gap =
                ray.cut(low, high, [&](bool below) { return end_at(below ? low : high, motion); });
            slow.cut(low, high);
            const auto expected = slow.intervals();
            const auto found = ray.intervals();
            ASSERT_EQ(found.size(), expected.size());
            std::int64_t length = 0;
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_EQ(found[i].low.at, expected[i][0]);
                EXPECT_EQ(found[i].high.at, expected[i][1]);
                length += expected[i][1] - expected[i][0];
            }
            EXPECT_EQ(ray.length(), length);
            // The gap contains the cut and ends at material.
            EXPECT_LE(gap.low, low);
            EXPECT_GE(gap.high, high);
            for (std::int32_t i = std::max(gap.low, -1); i < std::min(gap.high, 61); ++i)
                EXPECT_FALSE(slow.in(i));
            if (gap.low > -Gap::kUnbounded) {
                EXPECT_TRUE(slow.in(gap.low - 1));
            }
            if (gap.high < Gap::kUnbounded) {
                EXPECT_TRUE(slow.in(gap.high));
            }
        }
    }
}

TEST(Ray, NamesTheMotionsThatLeftItsEnds) {
    Ray ray;
    ray.set({end_at(0, 0), end_at(100, 0)});
    const auto cut = [&](std::int32_t low, std::int32_t high, std::uint32_t motion) {
        ray.cut(low, high, [&](bool below) { return end_at(below ? low : high, motion); });
    };
    cut(90, 120, 1);
    cut(40, 50, 2);
    cut(45, 60, 3);
    cut(92, 95, 4);  // there is no material
    ASSERT_EQ(ray.intervals().size(), 2U);
    EXPECT_EQ(ray.intervals()[0].high.origin, cda::Origin{2});
    EXPECT_EQ(ray.intervals()[1].low.origin, cda::Origin{3});
    EXPECT_EQ(ray.intervals()[1].high.origin, cda::Origin{1});
    const Ray copy = ray;
    cut(0, 100, 5);
    EXPECT_TRUE(ray.intervals().empty());
    EXPECT_EQ(copy.intervals().size(), 2U);
}

TEST(PackedNormal, IsOffByATenThousandthAtMost) {
    test::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n =
            normalized(Vec3{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)});
        EXPECT_LT(norm(PackedNormal::of(n).unpacked() - n), 1e-4);
    }
}

TEST(GridAxis, FindsTheFirstCornerBeyond) {
    test::Random random(4);
    for (const double pitch : {2.0, 3.7, 1234.5}) {
        const GridAxis axis(-5000, 7000, pitch);
        for (int i = 0; i < 2000; ++i) {
            const double place = std::floor(random.within(-9000, 9000)) + 0.5 * (i % 2);
            const auto slow = std::ranges::lower_bound(axis.at, place) - axis.at.begin();
            EXPECT_EQ(axis.from(place), static_cast<std::size_t>(slow));
        }
    }
}

}  // namespace
}  // namespace ncsim::dexel
