// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the components and polygons of the 256 kinds of grid cells.
#include "cell_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

namespace ncsim::dexel {
namespace {

TEST(CellComponents, EdgesAndCornersAgree) {
    for (int edge = 0; edge < 12; ++edge)
        EXPECT_EQ(edge_from(first_corner(edge), edge / 4), edge);
}

TEST(CellComponents, CrossedEdgesHaveAPieceAndOthersNone) {
    for (int inside = 0; inside < 256; ++inside) {
        const CellComponents& c = components_of(static_cast<std::uint8_t>(inside));
        for (int edge = 0; edge < 12; ++edge) {
            const int a = first_corner(edge);
            const int b = a + (1 << edge / 4);
            const bool crossed = (inside >> a & 1) != (inside >> b & 1);
            EXPECT_EQ(c.of_edge[static_cast<std::size_t>(edge)] != CellComponents::kNone, crossed);
        }
    }
}

TEST(CellComponents, ASingleCornerIsOnePieceAndCornersAtADiagonalAreTwo) {
    EXPECT_EQ(components_of(0).count, 0);
    EXPECT_EQ(components_of(255).count, 0);
    EXPECT_EQ(components_of(0b00000001).count, 1);
    EXPECT_EQ(components_of(0b00001001).count, 2);  // diagonal of a face
    EXPECT_EQ(components_of(0b10000001).count, 2);  // diagonal of the cell
    EXPECT_EQ(components_of(0b01101001).count, 4);  // every second corner
    EXPECT_EQ(components_of(0b00001111).count, 1);
}

// Each crossed edge is in exactly one polygon. Each polygon has at least three edges, all of the
// same piece.
TEST(CellComponents, PolygonsHaveEachCrossedEdgeOnce) {
    for (int inside = 0; inside < 256; ++inside) {
        SCOPED_TRACE(inside);
        const auto bits = static_cast<std::uint8_t>(inside);
        const CellComponents& pieces = components_of(bits);
        std::array<int, 12> times{};
        EXPECT_EQ(loops_of(bits).size(), pieces.count);
        for (const auto& loop : loops_of(bits)) {
            EXPECT_GE(loop.size(), 3U);
            for (const std::uint8_t edge : loop) {
                ++times[edge];
                EXPECT_EQ(pieces.of_edge[edge], pieces.of_edge[loop.front()]);
            }
        }
        for (std::size_t edge = 0; edge < 12; ++edge)
            EXPECT_EQ(times[edge], pieces.of_edge[edge] == CellComponents::kNone ? 0 : 1);
    }
}

// The number of pieces does not change when the cell is rotated: no axis is special.
TEST(CellComponents, DoNotDependOnHowTheCellLies) {
    const auto turned = [](int corner) {
        return (corner >> 2 & 1) | (corner & 1) << 1 | (corner >> 1 & 1) << 2;
    };
    for (int inside = 0; inside < 256; ++inside) {
        int other = 0;
        for (int corner = 0; corner < 8; ++corner)
            other |= (inside >> corner & 1) << turned(corner);
        EXPECT_EQ(components_of(static_cast<std::uint8_t>(inside)).count,
                  components_of(static_cast<std::uint8_t>(other)).count)
            << inside;
    }
}

}  // namespace
}  // namespace ncsim::dexel
