// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part in tiles: each is cut by somebody else, and what they know is put together to the same
// part, corner for corner and bit for bit. The blocks of the tree know nothing of each other, so a
// tile is some of them; everybody makes the same cuts, and takes in what meets its own blocks.
// docs/cda.md, "Tiles".
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/workpiece.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::cda {

/// What all tiles of a part know.
class Tiles {
public:
    /// `tiles[i]` is what WorkpieceModel::write_tile wrote for tile i. Points are computed again
    /// from their planes: what does not fit is no tile. Throws std::invalid_argument, "tile I:
    /// why", also if they are not of one part.
    explicit Tiles(std::vector<std::string> tiles);
    ~Tiles();
    Tiles(const Tiles&) = delete;
    Tiles& operator=(const Tiles&) = delete;

    /// The part, as a prototype: whoever makes the cuts once more, which cost nothing then, and
    /// asks for volumes when the tiles did, is told what they found, together.
    static std::unique_ptr<WorkpieceModel> model(std::shared_ptr<const Tiles> tiles);

private:
    class Model;
    struct Block;

    std::vector<Block> blocks_;
    std::size_t volumes_ = 0;  // how often they were asked for
};

}  // namespace ncsim::cda
