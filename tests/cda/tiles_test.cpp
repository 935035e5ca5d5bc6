// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/tiles.h"

#include "ncsim/cda/tree.h"

#include "support/passes.h"
#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::random_cuts;

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

// Cuts, with what is wanted of each step, and on the way it is asked for the volume.
std::vector<double> mill(WorkpieceModel& part, const std::vector<Cell>& cuts) {
    std::vector<double> volumes{part.volume()};
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const std::optional<Box> wanted = part.wanted();
        const bool is_wanted = !wanted || wanted->overlaps(cuts[i].bounds);
        part.subtract_step(is_wanted ? std::span(&cuts[i], 1) : std::span<const Cell>());
        if (i == cuts.size() / 3) volumes.push_back(part.volume());
    }
    volumes.push_back(part.volume());
    return volumes;
}

// Few may wait: blocks are settled in the middle of it.
TreeParameters parameters_for(std::optional<TileNumber> tile) {
    TreeParameters parameters;
    parameters.batch = 7;
    parameters.threads = 2;
    parameters.tile = tile;
    return parameters;
}

std::vector<std::string> tiles_of(const Cell& stock, const std::vector<Cell>& cuts,
                                  std::uint32_t of) {
    std::vector<std::string> tiles;
    for (std::uint32_t i = 0; i < of; ++i) {
        TreeCda part(stock, kLattice, parameters_for(TileNumber{i, of}));
        mill(part, cuts);
        std::ostringstream bytes;
        part.write_tile(bytes);
        tiles.push_back(std::move(bytes).str());
    }
    return tiles;
}

void expect_same(const Boundary& a, const Boundary& b) {
    ASSERT_EQ(a.faces.size(), b.faces.size());
    EXPECT_TRUE(a.vertices == b.vertices);
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
        EXPECT_EQ(a.faces[i].origin, b.faces[i].origin);
        EXPECT_EQ(a.faces[i].loops, b.faces[i].loops);
    }
}

TEST(Tiles, AreOnePartToTheLastBit) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const auto cuts = random_cuts(seed, 60, 20000 + static_cast<std::int64_t>(seed) * 8000);
        TreeCda whole(kStock, kLattice, parameters_for({}));
        const std::vector<double> volumes = mill(whole, cuts);
        for (const std::uint32_t of : {1U, 2U, 7U, kMostTiles}) {
            SCOPED_TRACE(of);
            const auto tiles = std::make_shared<const Tiles>(tiles_of(kStock, cuts, of));
            const auto part = Tiles::model(tiles)->create(kStock, kLattice);
            EXPECT_EQ(mill(*part, cuts), volumes);
            expect_same(part->boundary(), whole.boundary());
            EXPECT_THROW((void)part->volume(), std::logic_error);  // once more than then
        }
    }
}

// Fewer blocks than tiles.
TEST(Tiles, MayHaveNothing) {
    const Cell stock = box_cell({0, 0, 0}, {3, 3, 3}, kLattice);
    TreeCda whole(stock, kLattice, parameters_for({}));
    const auto part = Tiles::model(std::make_shared<const Tiles>(tiles_of(stock, {}, kMostTiles)))
                          ->create(stock, kLattice);
    EXPECT_EQ(mill(*part, {}), mill(whole, {}));
    expect_same(part->boundary(), whole.boundary());
}

TEST(Tiles, AreAskedForNothingElse) {
    TreeCda tile(kStock, kLattice, parameters_for(TileNumber{0, 2}));
    EXPECT_THROW((void)tile.boundary(), CannotAnswer);
    std::ostringstream bytes;
    EXPECT_THROW(TreeCda(kStock, kLattice).write_tile(bytes), CannotAnswer);
    const auto part = Tiles::model(std::make_shared<const Tiles>(tiles_of(kStock, {}, 1)))
                          ->create(kStock, kLattice);
    EXPECT_THROW((void)part->contains({}), CannotAnswer);
    EXPECT_THROW((void)part->account(), CannotAnswer);
    EXPECT_THROW(part->subtract(kStock), CannotAnswer);
}

TEST(Tiles, ThatAreNoneAreRefused) {
    const auto cuts = random_cuts(3, 10, 60000);
    const std::vector<std::string> tiles = tiles_of(kStock, cuts, 2);
    const auto refused = [](std::vector<std::string> some) {
        EXPECT_THROW(Tiles{std::move(some)}, std::invalid_argument);
    };
    refused({});
    refused({tiles[0]});
    refused({tiles[1], tiles[0]});
    refused({tiles[0], tiles[0]});
    refused({tiles[0], tiles[1], tiles[1]});
    refused({tiles[0], tiles[1] + '\0'});
    // As many blocks, asked for their volume more often.
    TreeCda other(kStock, kLattice, parameters_for(TileNumber{1, 2}));
    mill(other, cuts);
    (void)other.volume();
    std::ostringstream bytes;
    other.write_tile(bytes);
    refused({tiles[0], std::move(bytes).str()});
    for (std::size_t size = 0; size < tiles[1].size(); size += 1 + size / 50)
        refused({tiles[0], tiles[1].substr(0, size)});
}

// Whatever stands in a file, there is a part or an exception.
TEST(Tiles, MayBeAnything) {
    test::Random random(11);
    const auto cuts = random_cuts(4, 6, 60000);
    const std::vector<std::string> tiles = tiles_of(kStock, cuts, 1);
    int accepted = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string bytes = tiles[0];
        const auto last = static_cast<std::int64_t>(bytes.size()) - 1;
        for (std::int64_t k = random.between(1, 3); k > 0; --k)
            bytes[static_cast<std::size_t>(random.between(0, last))] ^=
                static_cast<char>(1 << random.between(0, 7));
        try {
            const auto part = Tiles::model(std::make_shared<const Tiles>(std::vector{bytes}))
                                  ->create(kStock, kLattice);
            (void)part->boundary();
            ++accepted;  // a volume, an origin
        } catch (const std::logic_error&) {
        }
    }
    EXPECT_LT(accepted, 1500);
}

}  // namespace
}  // namespace ncsim::cda
