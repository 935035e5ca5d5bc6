// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the table that numbers keys in order of first occurrence.
#include "exact/interner.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ncsim::cda {
namespace {

struct Good {
    std::uint64_t operator()(std::uint64_t key) const { return mix(key, 1); }
};
// Hash that puts all keys in the same place.
struct Bad {
    std::uint64_t operator()(std::uint64_t) const { return 0; }
};

std::vector<std::uint64_t> random_keys(std::size_t count, std::int64_t different) {
    test::Random random(41);
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 0; i < count; ++i)
        keys.push_back(static_cast<std::uint64_t>(random.between(0, different)) << 40);
    return keys;
}

template <class Hash>
void expect_numbers_in_order_of_first_sight(const std::vector<std::uint64_t>& keys) {
    Interner<std::uint64_t, Hash> one_by_one;
    Interner<std::uint64_t, Hash> all;
    std::vector<std::uint32_t> numbers;
    all.number_all(keys, [&](std::size_t i, std::uint32_t number) {
        EXPECT_EQ(i, numbers.size());
        numbers.push_back(number);
    });
    ASSERT_EQ(numbers.size(), keys.size());
    std::unordered_map<std::uint64_t, std::uint32_t> expected;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto next = static_cast<std::uint32_t>(expected.size());
        const std::uint32_t number = expected.try_emplace(keys[i], next).first->second;
        ASSERT_EQ(one_by_one(keys[i]), number);
        ASSERT_EQ(numbers[i], number);
        ASSERT_EQ(all.keys()[number], keys[i]);
    }
    EXPECT_EQ(one_by_one.size(), expected.size());
    EXPECT_EQ(all.size(), expected.size());
}

TEST(Interner, NumbersKeysInOrderOfFirstSight) {
    expect_numbers_in_order_of_first_sight<Good>(random_keys(100'000, 30'000));
    expect_numbers_in_order_of_first_sight<Good>(random_keys(5, 1));
    expect_numbers_in_order_of_first_sight<Good>({});
}

TEST(Interner, NumbersManyKeysAsOneByOne) {
    struct Hash {
        std::uint64_t operator()(const std::uint64_t& key) const { return mix(0, key / 2); }
    };
    test::Random random(3);
    Interner<std::uint64_t, Hash> one_by_one;
    Interner<std::uint64_t, Hash> together;
    for (const std::size_t count : {0U, 1U, 7U, 8U, 15U, 16U, 17U, 1000U, 20000U}) {
        std::vector<std::uint64_t> keys;
        std::vector<std::uint32_t> expected;
        for (std::size_t i = 0; i < count; ++i) {
            keys.push_back(static_cast<std::uint64_t>(random.between(0, 12000)));
            expected.push_back(one_by_one(keys.back()));
        }
        std::vector<std::uint32_t> numbers(count, ~std::uint32_t{0});
        together.number_all(keys, [&](std::size_t i, std::uint32_t n) { numbers[i] = n; });
        EXPECT_EQ(numbers, expected);
    }
    ASSERT_EQ(together.size(), one_by_one.size());
    for (std::size_t i = 0; i < together.size(); ++i)
        EXPECT_EQ(together.keys()[i], one_by_one.keys()[i]);
    EXPECT_GT(together.size(), 5000U);  // in several chunks
}

TEST(Interner, AsksKeysWhoseHashesAreEqual) {
    expect_numbers_in_order_of_first_sight<Bad>(random_keys(2'000, 300));
}

TEST(Interner, ForgetsAndBeginsAnew) {
    Interner<std::uint64_t, Good> numbers;
    EXPECT_EQ(numbers(7), 0U);
    EXPECT_EQ(numbers(8), 1U);
    numbers.clear();
    EXPECT_EQ(numbers.size(), 0U);
    EXPECT_EQ(numbers(8), 0U);
    EXPECT_EQ(numbers(7), 1U);
}

}  // namespace
}  // namespace ncsim::cda
