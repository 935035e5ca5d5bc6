// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part in tiles: each is cut by somebody else, and what they know is put together to the same
// part, corner for corner and bit for bit. The blocks of the tree know nothing of each other, so a
// tile is some of them; everybody makes the same cuts, and takes in what meets its own blocks.
// docs/cda.md, "Tiles".
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

/// What all tiles of a part know. Of most of it only where it is: tiles are read when somebody asks
/// for a surface, and again when somebody asks again.
class Tiles {
public:
    /// What WorkpieceModel::write_tile wrote for the tile of that number. Many threads may ask.
    using Read = std::function<std::string(std::size_t)>;

    /// Reads all `count` of them, one by one, and keeps their volumes and borders. Throws
    /// std::invalid_argument, "tile I: why", if one is no tile, or they are not of one part; and
    /// what `read` throws.
    Tiles(std::size_t count, Read read, std::size_t threads = 0);
    /// The same of tiles that somebody has.
    explicit Tiles(std::vector<std::string> tiles);
    ~Tiles();
    Tiles(const Tiles&) = delete;
    Tiles& operator=(const Tiles&) = delete;

    std::size_t size() const;

    /// The part, as a prototype: whoever makes the cuts once more, which cost nothing then, and
    /// asks for volumes when the tiles did, is told what they found, together. Points are computed
    /// again from their planes: where one is elsewhere, or the surface is not closed, boundary()
    /// throws std::runtime_error.
    static std::unique_ptr<WorkpieceModel> model(std::shared_ptr<const Tiles> tiles);

    /// The surface of the part as far as the tile goes: open at its walls, and cut there where the
    /// neighbours' is. The open edges of all tiles together are pairs of opposite directions with
    /// the same ends, to the last bit. Reads this tile. Throws as boundary() does. May be asked by
    /// many threads.
    Boundary surface(std::size_t tile, const Lattice& lattice) const;

private:
    class Model;
    struct Tile;

    std::vector<Outlines> outlines_of(std::size_t tile) const;

    // Which one has a block, as the how manieth of its own.
    struct OfTile {
        std::size_t tile;
        std::uint32_t number;
    };

    Read read_;
    std::size_t threads_;
    std::vector<Tile> tiles_;
    std::vector<OfTile> blocks_;
    std::size_t volumes_ = 0;  // how often they were asked for
};

}  // namespace ncsim::cda
