// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the tree of a block with unit cubes.
#include "tree/block_tree.h"

#include "block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ncsim::cda {
namespace {

constexpr std::int64_t kSize = 12;

// Compares material with unit cubes, for leaves and batches of any size.
TEST(BlockTree, HasTheMaterialThatNoCellHas) {
    test::Random random(81);
    for (int scene = 0; scene < 60; ++scene) {
        SCOPED_TRACE(scene);
        TestBlock block(kSize);
        std::vector<UnitBox> boxes;
        for (std::int64_t batches = random.between(1, 4); batches > 0; --batches) {
            std::vector<Cell> cells;
            for (std::int64_t n = random.between(1, 12); n > 0; --n) {
                boxes.push_back(random_unit_box(random, kSize));
                cells.push_back(
                    boxes.back().cell(Origin{static_cast<std::uint32_t>(boxes.size())}));
            }
            block.cut(cells, static_cast<std::uint32_t>(random.between(6, 40)));
        }
        for (std::int64_t x = 0; x < kSize; ++x) {
            for (std::int64_t y = 0; y < kSize; ++y) {
                for (std::int64_t z = 0; z < kSize; ++z) {
                    const LatticePoint p{x, y, z};
                    ASSERT_EQ(block.has(p), std::ranges::none_of(
                                                boxes, [&](const UnitBox& b) { return b.has(p); }));
                }
            }
        }
    }
}

TEST(BlockTree, IsEmptyForGoodWhereACellCoversIt) {
    TestBlock block(kSize);
    block.cut({UnitBox{{-1, -1, -1}, {kSize + 1, kSize + 1, kSize + 1}}.cell(Origin{1})});
    bool any = false;
    block.tree().visit([](const HalfBox&) { return true; },
                       [&](const HalfBox&, std::span<const BlockTree::Entry>) { any = true; });
    EXPECT_FALSE(any);
    EXPECT_EQ(block.tree().nodes(), 1U);
    EXPECT_EQ(block.tree().planes(), 0U);
}

TEST(BlockTree, ShrinksWhereACellCoversOneSide) {
    TestBlock block(kSize);
    block.cut({UnitBox{{-1, -1, 8}, {kSize + 1, kSize + 1, kSize + 1}}.cell(Origin{1})});
    // The next odd numbers beyond the cell.
    EXPECT_LE(block.tree().box().max[2], 2 * 8 + 3);
    EXPECT_EQ(block.tree().box().min[2], -1);
}

TEST(BlockTree, KeepsOneOfCellsThatCoverEachOther) {
    TestBlock block(kSize);
    std::vector<Cell> cells;
    for (std::uint32_t i = 0; i < 30; ++i)
        cells.push_back(UnitBox{{2, 2, 2}, {5, 5, 5}}.cell(Origin{i + 1}));
    cells.push_back(UnitBox{{2, 2, 2}, {9, 9, 9}}.cell(Origin{99}));
    block.cut(cells);
    std::size_t most = 0;
    block.tree().visit([](const HalfBox&) { return true; },
                       [&](const HalfBox&, std::span<const BlockTree::Entry> entries) {
                           most = std::max(most, entries.size());
                       });
    EXPECT_LT(most, 5U);
    EXPECT_FALSE(block.has({8, 8, 8}));
    EXPECT_TRUE(block.has({1, 1, 1}));
}

TEST(BlockTree, BooksEachUnitToTheFirstThatTakesIt) {
    test::Random random(82);
    for (int scene = 0; scene < 20; ++scene) {
        SCOPED_TRACE(scene);
        TestBlock block(kSize);
        std::vector<UnitBox> boxes;
        std::vector<Cell> cells;
        std::vector<IncomingCell> incoming(8);
        CellTable table;
        std::vector<const IncomingCell*> pointers;
        for (std::uint32_t i = 0; i < 8; ++i) {
            boxes.push_back(random_unit_box(random, kSize));
            cells.push_back(boxes.back().cell(Origin{i + 1}));
        }
        for (std::uint32_t i = 0; i < 8; ++i) {
            IncomingCell& here = incoming[i];
            here.number = i;
            here.planes = cells[i].planes;
            here.loose = {0, 1, 2, 3, 4, 5};
            here.enclose(cells[i].bounds, test::kLattice.unit_mm);
            table.add(Origin{i + 1}, Cell::kFirstRank, nullptr);
            if (block.tree().meets(here)) pointers.push_back(&here);
        }
        std::vector<RemovedByTurn> removed;
        block.tree().account(pointers, {block.stock(), table, Vec3{6, 6, 6}, 20}, removed);
        std::vector<double> expected(9, 0.0);
        for (std::int64_t at = 0; at < kSize * kSize * kSize; ++at) {
            const LatticePoint p{at % kSize, at / kSize % kSize, at / kSize / kSize};
            const auto first =
                std::ranges::find_if(boxes, [&](const UnitBox& b) { return b.has(p); });
            if (first != boxes.end())
                expected[static_cast<std::size_t>(first - boxes.begin()) + 1] += 1.0;
        }
        std::vector<double> booked(9, 0.0);
        for (const RemovedByTurn& turn : removed)
            booked[static_cast<std::size_t>(turn.origin)] += turn.volume;
        for (std::size_t i = 1; i < booked.size(); ++i)
            EXPECT_NEAR(booked[i], expected[i], 1e-9) << i;
    }
}

}  // namespace
}  // namespace ncsim::cda
