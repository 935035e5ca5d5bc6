// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the compressed storage of cells and planes.
#include "tree/plane_store.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <utility>

namespace ncsim::cda {
namespace {

TEST(PackedCells, GiveBackWhatWasWritten) {
    test::Random random(11);
    for (int i = 0; i < 2000; ++i) {
        PackedCells::Words words;
        // Numbers of a random size, so that some are near each other.
        const int bits = static_cast<int>(random.between(1, 32));
        const auto number = [&] {
            return static_cast<std::uint32_t>(random.next() >> (64 - bits));
        };
        for (std::int64_t cells = random.between(0, 5); cells > 0; --cells) {
            words.push_back(number());
            const auto planes = static_cast<std::uint32_t>(random.between(0, 300));
            words.push_back(planes);
            for (std::uint32_t k = 0; k < planes; ++k)
                words.push_back(number());
        }
        PackedCells packed;
        packed.write(words);
        EXPECT_EQ(packed.is_empty(), words.empty());
        PackedCells::Words read{1, 2, 3};
        packed.read(read);
        ASSERT_EQ(read, words);
        const PackedCells copy = packed;
        packed.write({7, 1, 4'294'967'295U});
        copy.read(read);
        ASSERT_EQ(read, words);
        packed.read(read);
        ASSERT_EQ(read, (PackedCells::Words{7, 1, 4'294'967'295U}));
    }
}

TEST(PackedCells, OfNeighboursTakeAByteANumber) {
    PackedCells::Words words;
    for (std::uint32_t cell = 100'000; cell < 100'010; ++cell) {
        words.insert(words.end(), {cell, 3, 3 * cell, 3 * cell + 1, 3 * cell + 2});
    }
    PackedCells packed;
    packed.write(words);
    EXPECT_LE(packed.memory(), words.size() + 10);
}

TEST(PlaneStore, GivesBackPlanesAndKeepsThemApart) {
    const Plane of_a_family{1, 2, 3, -(std::int64_t{1} << 51)};
    const Plane other{-5, 0, 1 << 24, 1234567890123};
    PlaneStore store;
    EXPECT_EQ(store.add(of_a_family, 7), 0U);
    EXPECT_EQ(store.add(other, PlaneStore::kLoose), 1U);
    EXPECT_EQ(store.add(of_a_family, 65534), 2U);
    EXPECT_EQ(store.facet(0), 7U);
    EXPECT_EQ(store.distance(0), of_a_family.d);
    EXPECT_EQ(store.facet(1), PlaneStore::kLoose);
    EXPECT_EQ(store.loose(1), other);
    EXPECT_EQ(store.facet(2), 65534U);

    PlaneStore kept;
    kept.add_from(store, 1);
    kept.add_from(store, 0);
    EXPECT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept.loose(0), other);
    EXPECT_EQ(kept.distance(1), of_a_family.d);
}

}  // namespace
}  // namespace ncsim::cda
