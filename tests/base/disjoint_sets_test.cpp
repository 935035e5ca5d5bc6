// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/base/disjoint_sets.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace ncsim {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Returns the representative of each number.
std::vector<std::uint32_t> joined(std::size_t size, const Pairs& pairs, std::size_t& count) {
    DisjointSets sets(size);
    for (const auto& [a, b] : pairs)
        sets.unite(a, b);
    count = sets.sets();
    std::vector<std::uint32_t> least;
    least.reserve(size);
    for (std::uint32_t i = 0; i < size; ++i)
        least.push_back(sets.find(i));
    return least;
}

TEST(DisjointSets, AreRepresentedByTheLeastNumber) {
    std::size_t count = 0;
    EXPECT_EQ(joined(4, {}, count), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(count, 4U);
    EXPECT_EQ(joined(5, {{4, 3}, {3, 2}, {4, 2}, {1, 1}}, count),
              (std::vector<std::uint32_t>{0, 1, 2, 2, 2}));
    EXPECT_EQ(count, 3U);
    EXPECT_TRUE(joined(0, {}, count).empty());
    EXPECT_EQ(count, 0U);
}

// Reference: a line of numbers with a colour per set.
TEST(DisjointSets, OfRandomPairsAreThoseOfAPaintedLineInAnyOrder) {
    test::Random random(7);
    for (int round = 0; round < 100; ++round) {
        constexpr std::uint32_t kSize = 40;
        Pairs pairs;
        pairs.reserve(static_cast<std::size_t>(round));
        for (int i = 0; i < round; ++i) {
            pairs.emplace_back(static_cast<std::uint32_t>(random.between(0, kSize - 1)),
                               static_cast<std::uint32_t>(random.between(0, kSize - 1)));
        }
        std::vector<std::uint32_t> colour(kSize);
        for (std::uint32_t i = 0; i < kSize; ++i)
            colour[i] = i;
        for (const auto& [a, b] : pairs) {
            const std::uint32_t to = std::min(colour[a], colour[b]);
            const std::uint32_t from = std::max(colour[a], colour[b]);
            std::ranges::replace(colour, from, to);
        }
        std::size_t count = 0;
        EXPECT_EQ(joined(kSize, pairs, count), colour);
        EXPECT_EQ(count, std::set(colour.begin(), colour.end()).size());
        std::ranges::reverse(pairs);
        EXPECT_EQ(joined(kSize, pairs, count), colour);
    }
}

}  // namespace
}  // namespace ncsim
