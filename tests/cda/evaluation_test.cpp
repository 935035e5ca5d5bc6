// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the volume and the outlines that a block evaluates to.
#include "tree/evaluation.h"

#include "block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ncsim::cda {
namespace {

constexpr std::int64_t kSize = 10;
constexpr double kHalf = 0.5 * kSize;

Evaluation evaluated(const TestBlock& block) {
    return evaluate(block.tree(), {block.stock(), nullptr, block.table(), {kHalf, kHalf, kHalf}});
}

TEST(Evaluation, OfAWholeBlockIsItsStock) {
    const TestBlock block(kSize);
    const Evaluation whole = evaluated(block);
    EXPECT_NEAR(whole.volume, 1000.0, 1e-9);
    // Six faces of four edges.
    EXPECT_EQ(whole.outlines.pieces().size(), 24U);
    EXPECT_EQ(whole.leaves, 1U);
}

// Compares the remaining volume, and the volume that a cell shares with the part, with unit cubes,
// for leaves of any size.
TEST(Evaluation, HasTheVolumeThatIsLeft) {
    test::Random random(91);
    for (int scene = 0; scene < 60; ++scene) {
        SCOPED_TRACE(scene);
        TestBlock block(kSize);
        std::vector<Cell> cells;
        for (std::uint32_t i = 1; i < 12; ++i)
            cells.push_back(random_unit_box(random, kSize).cell(Origin{i}));
        block.cut(cells, static_cast<std::uint32_t>(random.between(6, 40)));
        const UnitBox window = random_unit_box(random, kSize);
        double left = 0.0;
        double common = 0.0;
        for (std::int64_t at = 0; at < kSize * kSize * kSize; ++at) {
            const LatticePoint p{at % kSize, at / kSize % kSize, at / kSize / kSize};
            if (!block.has(p)) continue;
            left += 1.0;
            if (window.has(p)) common += 1.0;
        }
        EXPECT_NEAR(evaluated(block).volume, left, 1e-9);
        const std::vector<Plane> planes = window.cell(Origin{99}).planes;
        EvaluationInput input{block.stock(), &planes, block.table(), {kHalf, kHalf, kHalf}};
        EXPECT_NEAR(evaluate(block.tree(), input).volume, common, 1e-9);
        input.only_first = true;
        EXPECT_EQ(evaluate(block.tree(), input).outlines.pieces().empty(), common == 0.0);
    }
}

// Two cells that touch a plane from both sides leave no wall there.
TEST(Evaluation, LeavesNoMembraneBetweenCellsThatTouch) {
    TestBlock block(kSize);
    block.cut({UnitBox{{2, 2, 2}, {5, 8, 8}}.cell(Origin{1}),
               UnitBox{{5, 2, 2}, {8, 8, 8}}.cell(Origin{2})});
    const Evaluation hollow = evaluated(block);
    EXPECT_NEAR(hollow.volume, 1000.0 - 6 * 6 * 6, 1e-9);
    for (const auto& piece : hollow.outlines.pieces()) {
        const Plane plane = hollow.outlines.plane(piece.plane);
        EXPECT_FALSE(std::abs(plane.nx) == 1 && std::abs(plane.d) == 5);
    }
}

// A face that two motions leave belongs to the first motion.
TEST(Evaluation, GivesAFaceToTheFirstOfTwo) {
    TestBlock block(kSize);
    block.cut({UnitBox{{2, 2, 4}, {6, 8, 11}}.cell(Origin{7}),
               UnitBox{{2, 2, 4}, {8, 8, 11}}.cell(Origin{3})});
    const Evaluation once = evaluated(block);
    EXPECT_FALSE(once.outlines.pieces().empty());
    for (const auto& piece : once.outlines.pieces())
        EXPECT_NE(piece.origin, Origin{7});
}

// Two passes along the same wall. The wall belongs to the deeper pass, from top to bottom, although
// the higher pass comes first. The leaf need not store the higher pass.
TEST(Evaluation, GivesAWallToTheLowerRank) {
    TestBlock block(kSize);
    std::vector<Cell> passes{UnitBox{{2, 2, 8}, {8, 8, 13}}.cell(Origin{3}),
                             UnitBox{{2, 2, 4}, {8, 8, 13}}.cell(Origin{7})};
    passes[0].rank = 8;
    passes[1].rank = 4;
    block.cut(passes);
    const Evaluation once = evaluated(block);
    EXPECT_FALSE(once.outlines.pieces().empty());
    for (const auto& piece : once.outlines.pieces())
        EXPECT_NE(piece.origin, Origin{3});
}

}  // namespace
}  // namespace ncsim::cda
