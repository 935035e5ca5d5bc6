// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the proof that a window is empty with unit cubes, and tests the purpose of the proof:
// queries while cells wait.
#include "tree/covering.h"

#include "ncsim/cda/tree.h"

#include "block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ncsim::cda {
namespace {

constexpr std::int64_t kSize = 24;

// True if `window` has no material once `waiting` is cut.
bool is_covered(const TestBlock& block, const UnitBox& window,
                const std::vector<IncomingCell>& waiting, std::size_t test_limit = 100000) {
    const std::vector<Plane> planes = window.cell(kStockOrigin).planes;
    const HalfBox bounds{{2 * window.min.x - 1, 2 * window.min.y - 1, 2 * window.min.z - 1},
                         {2 * window.max.x + 1, 2 * window.max.y + 1, 2 * window.max.z + 1}};
    std::vector<const IncomingCell*> pointers;
    for (const IncomingCell& cell : waiting)
        pointers.push_back(&cell);
    return is_covered(block.tree(), {planes, bounds, pointers, block.table(), test_limit});
}

TEST(Covering, ClaimsNothingThatAUnitCubeDenies) {
    test::Random random(301);
    int covered = 0;
    int found = 0;
    for (int scene = 0; scene < 400; ++scene) {
        SCOPED_TRACE(scene);
        TestBlock block(kSize);
        std::vector<UnitBox> boxes;
        const auto another = [&] {
            // Most boxes are as high as the stock, like the cells of tools.
            UnitBox box = random_unit_box(random, kSize);
            if (!random.one_in(4)) {
                box.min.z = -1;
                box.max.z = kSize + 1;
            }
            boxes.push_back(box);
            return box.cell(Origin{static_cast<std::uint32_t>(boxes.size())});
        };
        std::vector<Cell> cells;
        for (std::int64_t n = random.between(0, 6); n > 0; --n)
            cells.push_back(another());
        block.cut(cells, static_cast<std::uint32_t>(random.between(6, 40)));
        std::vector<IncomingCell> waiting;
        for (std::int64_t n = random.between(0, 10); n > 0; --n)
            waiting.push_back(block.receive(another()));
        for (int question = 0; question < 10; ++question) {
            const UnitBox window = random_unit_box(random, kSize);
            bool is_so = true;
            for (std::int64_t x = 0; x < kSize && is_so; ++x) {
                for (std::int64_t y = 0; y < kSize && is_so; ++y) {
                    for (std::int64_t z = 0; z < kSize && is_so; ++z) {
                        const LatticePoint p{x, y, z};
                        is_so = !window.has(p) || std::ranges::any_of(boxes, [&](const UnitBox& b) {
                            return b.has(p);
                        });
                    }
                }
            }
            const bool is_found = is_covered(block, window, waiting);
            if (is_found) {
                ASSERT_TRUE(is_so);
            }
            covered += is_so ? 1 : 0;
            found += is_found ? 1 : 0;
        }
    }
    EXPECT_GT(covered, 300);
    // At a plane where two cells only touch, no single cell contains a box, so the proof may fail.
    EXPECT_GT(found, covered * 4 / 5);
}

TEST(Covering, NeedsFewLooksWhereManyCellsCoverEachOther) {
    TestBlock block(1000);
    std::vector<IncomingCell> waiting;
    for (std::int64_t x = 0; x < 500; x += 5) {
        waiting.push_back(
            block.receive(UnitBox{{x, 100, -1}, {x + 200, 400, 1001}}.cell(Origin{1})));
    }
    const UnitBox cleared{{10, 100, -1}, {600, 400, 1001}};
    const UnitBox beyond{{10, 99, -1}, {600, 400, 1001}};
    EXPECT_TRUE(is_covered(block, cleared, waiting, 5000));
    EXPECT_FALSE(is_covered(block, cleared, waiting, 50));
    EXPECT_FALSE(is_covered(block, beyond, waiting));
}

TEST(Covering, SparesCellsThatWaitFromBeingTakenIn) {
    const Cell stock = box_cell({0, 0, 0}, {100000, 100000, 20000}, test::kLattice);
    TreeCda part(stock, test::kLattice);
    const auto pass = [](std::int64_t x, std::int64_t wide) {
        return box_cell({x, 20000, 5000}, {x + wide, 50000, 20001}, test::kLattice, Origin{1});
    };
    for (std::int64_t x = 0; x < 50000; x += 1000)
        part.subtract_unmeasured(pass(x, 10000));
    EXPECT_FALSE(part.contact(pass(500, 50000)));
    EXPECT_EQ(part.counts().spared, 1U);  // counts() inserts the waiting cells
    for (std::int64_t x = 50000; x < 60000; x += 1000)
        part.subtract_unmeasured(pass(x, 10000));
    // A unit beyond the cleared region.
    EXPECT_TRUE(part.contact(pass(500, 68501)));
    EXPECT_FALSE(part.contact(pass(500, 68500)));
    EXPECT_EQ(part.counts().spared, 1U);
}

}  // namespace
}  // namespace ncsim::cda
