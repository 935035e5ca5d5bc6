// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part in tiles. Each process simulates one tile; the results are combined to the same part,
// corner for corner and bit for bit. The blocks of the tree are independent, so a tile is a set of
// blocks. Every process executes the same cuts and inserts the cells that meet the blocks of the
// tile. See docs/cda.md, "Tiles".
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/workpiece.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::cda {

class Outlines;

/// The results of all tiles of a part. Headers and borders stay in memory; a tile's surface is read
/// again on every request.
class Tiles {
public:
    /// Returns the output of TreeCda::write_tile for the tile of the given number. Called
    /// from many threads.
    using Read = std::function<std::string(std::size_t)>;

    /// Reads all `count` tiles one by one and keeps volumes and borders.
    /// Throws: std::invalid_argument, "tile I: why", if the data is not a tile, or the tiles belong
    /// to different parts; and the exceptions of `read`.
    Tiles(std::size_t count, Read read, std::size_t threads = 0);
    /// The same for tiles in memory.
    explicit Tiles(const std::vector<std::string>& tiles);
    ~Tiles();
    Tiles(const Tiles&) = delete;
    Tiles& operator=(const Tiles&) = delete;

    std::size_t size() const;

    /// Returns the part as a prototype. If the caller repeats the cuts, which cost no time, and
    /// requests volumes at the same places as the tiles did, the prototype returns the sums of the
    /// tiles' volumes. Points are computed again from planes. boundary() throws std::runtime_error
    /// if a point differs or the surface is not closed.
    static std::unique_ptr<WorkpieceModel> model(std::shared_ptr<const Tiles> tiles);

    /// Returns the surface of the part within the tile: open at the tile's walls, and divided there
    /// at the same points as in adjacent tiles. The open edges of all tiles together are pairs of
    /// opposite directions with the same end points, to the last bit. Reads this tile. May be
    /// called from many threads. Throws: same as boundary().
    Boundary surface(std::size_t tile, const Lattice& lattice) const;

private:
    class Model;
    struct Tile;

    std::vector<Outlines> outlines_of(std::size_t tile) const;

    // Tile of a block, and the index among the tile's blocks.
    struct TileIndex {
        std::size_t tile;
        std::uint32_t number;
    };

    Read read_;
    std::size_t threads_;
    std::vector<Tile> tiles_;
    std::vector<TileIndex> blocks_;
    std::size_t volumes_ = 0;  // number of volume requests
};

}  // namespace ncsim::cda
