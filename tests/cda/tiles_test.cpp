// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests parts in tiles against the whole part: surfaces, volumes, queries and files.
#include "ncsim/cda/tiles.h"

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/tree.h"

#include "support/passes.h"
#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
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

// Subtracts `cuts`, each step only if the part wants the step's cells. Returns the volumes before,
// during and after the cuts.
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

// Returns parameters with a small batch, so blocks are settled between the cuts.
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
        for (const std::uint32_t of : {1U, 2U, 7U, 64U}) {
            SCOPED_TRACE(of);
            const auto tiles = std::make_shared<const Tiles>(tiles_of(kStock, cuts, of));
            const auto part = Tiles::model(tiles)->create(kStock, kLattice);
            EXPECT_EQ(mill(*part, cuts), volumes);
            expect_same(part->boundary(), whole.boundary());
            EXPECT_THROW((void)part->volume(), std::logic_error);  // more queries than the tiles
                                                                   // recorded
        }
    }
}

// A stock with fewer blocks than tiles.
TEST(Tiles, MayHaveNothing) {
    const Cell stock = box_cell({0, 0, 0}, {3, 3, 3}, kLattice);
    TreeCda whole(stock, kLattice, parameters_for({}));
    const auto part = Tiles::model(std::make_shared<const Tiles>(tiles_of(stock, {}, 64)))
                          ->create(stock, kLattice);
    EXPECT_EQ(mill(*part, {}), mill(whole, {}));
    expect_same(part->boundary(), whole.boundary());
}

TEST(Tiles, AloneHaveNoSurface) {
    EXPECT_THROW((void)TreeCda(kStock, kLattice, parameters_for(TileNumber{0, 2})).boundary(),
                 std::logic_error);
}

TEST(Tiles, TogetherKnowWhichPointsAreInThePart) {
    const auto cuts = random_cuts(5, 20, 60000);
    TreeCda whole(kStock, kLattice, parameters_for({}));
    mill(whole, cuts);
    const auto part = Tiles::model(std::make_shared<const Tiles>(tiles_of(kStock, cuts, 3)))
                          ->create(kStock, kLattice);
    std::size_t inside = 0;
    for (int i = 0; i < 125; ++i) {
        const Vec3 point{i / 25 * 1.53 - 3.07, i / 5 % 5 * 1.51 - 3.03, i % 5 * 1.49 - 2.99};
        EXPECT_EQ(part->contains(point), whole.contains(point)) << i;
        inside += part->contains(point) ? 1 : 0;
    }
    EXPECT_GT(inside, 10U);
    EXPECT_LT(inside, 115U);
    EXPECT_EQ(part->subtract(cuts[0]), 0.0);  // is cut already
}

using DirectedEdge = std::pair<Vec3, Vec3>;
struct Earlier {
    bool operator()(const DirectedEdge& a, const DirectedEdge& b) const {
        const auto key = [](const DirectedEdge& e) {
            return std::array{e.first.x, e.first.y, e.first.z, e.second.x, e.second.y, e.second.z};
        };
        return key(a) < key(b);
    }
};

// Returns the signed volume between a surface and the origin; the surface may be open.
double flux_of(const Boundary& surface) {
    double sixfold = 0.0;
    for (const BoundaryFace& face : surface.faces) {
        for (const auto& loop : face.loops) {
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                sixfold += dot(surface.vertices[loop[0]],
                               cross(surface.vertices[loop[i]], surface.vertices[loop[i + 1]]));
            }
        }
    }
    return sixfold / 6.0;
}

// Surfaces of all tiles: `net` is the number of occurrences of each edge minus occurrences of the
// reversed edge.
struct Together {
    std::map<DirectedEdge, int, Earlier> net;
    double area = 0.0, volume = 0.0;
    std::size_t open = 0;

    Together(const Tiles& tiles, const Lattice& lattice) {
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const Boundary piece = tiles.surface(i, lattice);
            std::map<DirectedEdge, int, Earlier> own;
            for (const BoundaryFace& face : piece.faces) {
                for (const auto& loop : face.loops) {
                    for (std::size_t k = 0; k < loop.size(); ++k) {
                        const Vec3 a = piece.vertices[loop[k]];
                        const Vec3 b = piece.vertices[loop[(k + 1) % loop.size()]];
                        ++own[{a, b}];
                        --own[{b, a}];
                    }
                }
            }
            for (const auto& [edge, count] : own) {
                net[edge] += count;
                open += count > 0 ? static_cast<std::size_t>(count) : 0;
            }
            area += cda::area(piece);
            volume += flux_of(piece);
        }
    }
    bool is_closed() const {
        return std::ranges::all_of(net, [](const auto& e) { return e.second == 0; });
    }
};

// Each tile has a surface of its own, and there is no gap between any two surfaces.
TEST(Tiles, HaveSurfacesThatFitTogether) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        const auto cuts = random_cuts(seed, 60, 20000 + static_cast<std::int64_t>(seed) * 12000);
        TreeCda whole(kStock, kLattice, parameters_for({}));
        mill(whole, cuts);
        const Boundary boundary = whole.boundary();
        for (const std::uint32_t of : {1U, 2U, 7U, 64U}) {
            SCOPED_TRACE(of);
            const Tiles tiles(tiles_of(kStock, cuts, of));
            const Together all(tiles, kLattice);
            EXPECT_TRUE(all.is_closed());
            EXPECT_EQ(all.open > 0, of > 1);
            EXPECT_NEAR(all.area, area(boundary), 1e-9 * area(boundary));
            EXPECT_NEAR(all.volume, volume(boundary), 1e-9 * volume(boundary));
        }
    }
}

// The part does not depend on the number of halvings or tiles.
TEST(Tiles, MayBeMany) {
    const auto cuts = random_cuts(5, 60, 60000);
    TreeCda whole(kStock, kLattice, parameters_for({}));
    mill(whole, cuts);
    constexpr std::uint32_t kMany = 1000;
    std::vector<std::string> bytes;
    std::size_t empty = 0;
    for (std::uint32_t i = 0; i < kMany; ++i) {
        TreeParameters parameters = parameters_for(TileNumber{i, kMany});
        parameters.halvings = 9;
        TreeCda tile(kStock, kLattice, parameters);
        mill(tile, cuts);
        std::ostringstream out;
        tile.write_tile(out);
        bytes.push_back(std::move(out).str());
        // The number of the tile's blocks.
        empty += bytes.back().substr(12, 4) == std::string(4, '\0') ? 1 : 0;
    }
    EXPECT_EQ(empty, kMany - 512);
    const auto tiles = std::make_shared<const Tiles>(std::move(bytes));
    const auto part = Tiles::model(tiles)->create(kStock, kLattice);
    expect_same(part->boundary(), whole.boundary());
    EXPECT_NEAR(part->volume(), 216.0, 1e-9);
    EXPECT_TRUE(Together(*tiles, kLattice).is_closed());
}

// Edges that lie in the wall between two tiles, and corners that only one tile has: a valley along
// the wall, of planes that are not parallel to the wall.
TEST(Tiles, ShareEdgesThatLieInTheirWalls) {
    const Cell stock = box_cell({0, 0, 0}, {64, 64, 64}, kLattice);
    // Returns a valley along y with its bottom at x = (x2 + 1) / 2 and z = 40 1/2. Walls of tiles
    // are also at odd half units.
    const auto valley = [&](std::int64_t x2, std::int32_t from, std::int32_t to, std::int32_t left,
                            std::int32_t right, std::uint32_t origin) {
        Cell cell = box_cell({0, from, 0}, {64, to, 64}, kLattice);
        cell.planes.push_back({right, 0, -1, (right * x2 - 1) / 2 - 40});
        cell.planes.push_back({-left, 0, -1, -(left * x2 + 1) / 2 - 40});
        cell.normals.reset();
        cell.origin = Origin{origin};
        return cell;
    };
    int in_walls = 0;
    for (std::int64_t x2 = 57; x2 <= 73; x2 += 2) {
        SCOPED_TRACE(x2);
        // A valley that ends on one side of the wall continues on the opposite side.
        const std::vector<Cell> cuts{valley(x2, 3, 20, 1, 1, 1), valley(x2, 20, 41, 3, 1, 2),
                                     valley(x2, 10, 50, 5, 3, 3), valley(x2, 30, 60, 1, 5, 4)};
        TreeCda whole(stock, kLattice, parameters_for({}));
        mill(whole, cuts);
        const Boundary boundary = whole.boundary();
        for (const std::uint32_t of : {2U, 64U}) {
            const Tiles tiles(tiles_of(stock, cuts, of));
            const Together all(tiles, kLattice);
            EXPECT_TRUE(all.is_closed());
            EXPECT_NEAR(all.volume, volume(boundary), 1e-9 * volume(boundary));
            // Counts edges along the bottom, in planes of x and z.
            for (const auto& [edge, count] : all.net) {
                if (edge.first.x == edge.second.x && edge.first.z == edge.second.z) ++in_walls;
            }
        }
    }
    EXPECT_GT(in_walls, 0);
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
    // A tile with the same blocks, but with a further query for the volume.
    TreeCda other(kStock, kLattice, parameters_for(TileNumber{1, 2}));
    mill(other, cuts);
    (void)other.volume();
    std::ostringstream bytes;
    other.write_tile(bytes);
    refused({tiles[0], std::move(bytes).str()});
    for (std::size_t size = 0; size < tiles[1].size(); size += 1 + size / 50)
        refused({tiles[0], tiles[1].substr(0, size)});
}

// Any content of a file yields a part or an exception.
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
            ++accepted;  // the flipped bits are in a volume or an origin
        } catch (const std::invalid_argument&) {
        } catch (const std::runtime_error&) {
        }
    }
    EXPECT_LT(accepted, 1500);
}

// Returns a cube; `low` and `size` are in mm.
Cell cube(Vec3 low, double size) {
    return box_cell(kLattice.round(low), kLattice.round(low + Vec3{size, size, size}), kLattice);
}

// Tiles answer queries as the whole part does. The part has a contact if a tile has a contact, and
// common volumes add up. A larger body has a contact with each tile that the body inside has a
// contact with.
TEST(Tiles, AnswerAsTheWholePartDoes) {
    test::Random random(5);
    int met = 0, missed = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<Cell> cuts = random_cuts(seed, 30, 30000);
        TreeCda whole(kStock, kLattice, parameters_for(std::nullopt));
        std::vector<TreeCda> tiles;
        for (const std::uint32_t of : {1U, 2U, 7U, 64U}) {
            for (std::uint32_t i = 0; i < of; ++i)
                tiles.emplace_back(kStock, kLattice, parameters_for(TileNumber{i, of}));
        }
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const auto coordinate = [&] { return 6.5 * random.unit() - 3.5; };
            const auto size = [&] { return i % 3 == 0 ? 0.2 : i % 3 == 1 ? 2.0 : 7.0; };
            const Vec3 low{coordinate(), coordinate(), coordinate()};
            const double grown = 1e-3;
            const Cell body = cube(low, size());
            const Cell larger = cube(low - Vec3{grown, grown, grown}, size() + 2.0 * grown);
            const bool expected = whole.contact(body).has_value();
            ++(expected ? met : missed);
            const double volume = whole.common_volume(body);
            std::size_t at = 0;
            for (const std::uint32_t of : {1U, 2U, 7U, 64U}) {
                bool is_met = false;
                double sum = 0.0;
                for (std::uint32_t k = 0; k < of; ++k, ++at) {
                    const auto point = tiles[at].contact(body);
                    is_met |= point.has_value();
                    if (point) {
                        EXPECT_TRUE(tiles[at].contact(larger));
                    }
                    sum += tiles[at].common_volume(body);
                }
                EXPECT_EQ(is_met, expected) << of;
                EXPECT_NEAR(sum, volume, 1e-9) << of;
            }
            const double removed = whole.subtract(cuts[i]);
            at = 0;
            for (const std::uint32_t of : {1U, 2U, 7U, 64U}) {
                double sum = 0.0;
                for (std::uint32_t k = 0; k < of; ++k)
                    sum += tiles[at++].subtract(cuts[i]);
                EXPECT_NEAR(sum, removed, 1e-9) << of;
            }
        }
    }
    EXPECT_GT(met, 20);
    EXPECT_GT(missed, 5);
}

// Each tile lies within the body, away from the body's surface.
TEST(Tiles, AreMetByWhatContainsThem) {
    const Cell all = mm_box(-9, -9, -9, 9, 9, 9);
    for (std::uint32_t i = 0; i < 64; ++i) {
        TreeCda tile(kStock, kLattice, parameters_for(TileNumber{i, 64}));
        EXPECT_TRUE(tile.contact(cube({-2.9, -2.9, -2.9}, 5.8))) << i;
        EXPECT_TRUE(tile.contact(all)) << i;
        tile.subtract(all);
        EXPECT_FALSE(tile.contact(all)) << i;
    }
}

}  // namespace
}  // namespace ncsim::cda
