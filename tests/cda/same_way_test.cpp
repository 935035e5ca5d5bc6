// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours in many depths: hulls along the same path, each deeper than the preceding hull.
#include "ncsim/cda/hull.h"
#include "ncsim/cda/tree.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

// Returns an upright tool with a flat or a pointed end.
TranslationSweep tool(bool is_pointed) {
    constexpr int kSides = 12;
    std::vector<LatticePoint> points;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 0.1 + 6.2831853 * i / kSides;
        const auto x = std::llround(70000 * std::cos(angle));
        const auto y = std::llround(70000 * std::sin(angle));
        points.push_back({x, y, is_pointed ? 30000 : 0});
        points.push_back({x, y, 900000});
    }
    if (is_pointed) points.push_back({0, 0, 0});
    return *TranslationSweep::of(points, kLattice);
}

// Returns the cells of a closed path of straight lines in level passes, alternately forwards and
// backwards.
std::vector<Cell> contour(const TranslationSweep& body, const std::vector<LatticePoint>& way,
                          int passes) {
    std::vector<Cell> cells;
    for (int pass = 0; pass < passes; ++pass) {
        const std::int64_t z = 250000 - 60000 * pass;
        for (std::size_t i = 1; i < way.size(); ++i) {
            const std::size_t k = pass % 2 == 0 ? i : way.size() - i;
            LatticePoint from = way[k - 1], to = way[k];
            from.z = to.z = z;
            if (pass % 2 != 0) std::swap(from, to);
            Cell cell = body(from, to, Origin{static_cast<std::uint32_t>(cells.size() + 1)});
            cell.rank = static_cast<std::int32_t>(z);
            cells.push_back(std::move(cell));
        }
    }
    return cells;
}

std::vector<LatticePoint> random_way(std::uint64_t seed) {
    Random random(seed);
    std::vector<LatticePoint> way;
    for (int i = 0; i < 9; ++i)
        way.push_back({random.between(-250000, 250000), random.between(-250000, 250000), 0});
    way.push_back(way.front());
    return way;
}

TEST(SameWay, DeeperPassesForgetTheOthersAndChangeNothing) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const auto way = random_way(seed);
        const auto cells = contour(tool(seed % 2 != 0), way, 8);
        TreeCda part(kStock, kLattice), settled(kStock, kLattice);
        for (const Cell& cell : cells) {
            part.subtract_step(std::span(&cell, 1));
            settled.subtract_unmeasured(cell);
            settled.settle();  // no cell waits, so no cell is forgotten
        }
        const Boundary found = part.boundary(), expected = settled.boundary();
        EXPECT_EQ(part.counts().superseded, cells.size() - (way.size() - 1));
        EXPECT_NEAR(part.volume(), settled.volume(), 1e-12 * settled.volume());
        EXPECT_TRUE(found.vertices == expected.vertices);
        ASSERT_EQ(found.faces.size(), expected.faces.size());
        for (std::size_t i = 0; i < found.faces.size(); ++i) {
            EXPECT_EQ(found.faces[i].origin, expected.faces[i].origin);
            EXPECT_EQ(found.faces[i].loops, expected.faces[i].loops);
        }
    }
}

// A flat end mill that rises cuts the floor of the deep pass, but that cell is not entirely within
// the higher cells.
TEST(SameWay, WhatIsHigherIsNotForgotten) {
    const TranslationSweep body = tool(false);
    auto cells = contour(body, random_way(3), 2);
    std::reverse(cells.begin(), cells.end());
    TreeCda part(kStock, kLattice);
    for (const Cell& cell : cells)
        part.subtract_step(std::span(&cell, 1));
    EXPECT_EQ(part.counts().superseded, 0U);
}

// A copy that is not cut deeper keeps the cells that the original forgets.
TEST(SameWay, CopiesForgetWhatLiesWithinTheirOwnCells) {
    const auto way = random_way(5);
    const auto cells = contour(tool(false), way, 2);
    const auto first = std::span(cells).first(way.size() - 1);
    const auto second = std::span(cells).subspan(way.size() - 1);
    TreeCda part(kStock, kLattice), alone(kStock, kLattice);
    part.subtract_unmeasured(first);
    alone.subtract_unmeasured(first);
    const TreeCda copy(part);
    part.subtract_unmeasured(second);
    EXPECT_EQ(part.counts().superseded, second.size());
    EXPECT_EQ(copy.volume(), alone.volume());
    EXPECT_LT(part.volume(), copy.volume());
}

// Two tools of the same shape have the same normals, though each has a list of its own.
TEST(SameWay, AToolOfTheSameShapeGoesOn) {
    const auto way = random_way(9);
    const auto cells = contour(tool(false), way, 2), others = contour(tool(false), way, 2);
    const std::size_t lines = way.size() - 1;
    ASSERT_NE(cells[0].normals, others[0].normals);
    TreeCda part(kStock, kLattice), one_tool(kStock, kLattice);
    part.subtract_unmeasured(std::span(cells).first(lines));
    part.subtract_unmeasured(std::span(others).subspan(lines));
    one_tool.subtract_unmeasured(cells);
    EXPECT_EQ(part.counts().superseded, lines);
    EXPECT_EQ(part.volume(), one_tool.volume());
}

// Accounts need the share of each origin.
TEST(SameWay, NothingIsForgottenThatIsBooked) {
    const auto cells = contour(tool(false), random_way(7), 4);
    TreeCda part(kStock, kLattice);
    part.track_removal();
    part.subtract_unmeasured(cells);
    EXPECT_EQ(part.counts().superseded, 0U);
    double sum = 0.0;
    for (const auto& [origin, taken] : part.account())
        sum += taken.volume;
    EXPECT_NEAR(sum, 216.0 - part.volume(), 1e-9);
}

}  // namespace
}  // namespace ncsim::cda
