// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of the stock: its tree, its share of the volume, and the cells that wait to go down.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/workpiece.h"

#include "surface/outlines.h"
#include "tree/block_tree.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::cda {

// A cell that some blocks have not taken in yet.
struct WaitingCell {
    Cell cell;
    IncomingCell incoming;
};

// A part of the tree and its share of the volume.
struct Block {
    std::shared_ptr<BlockTree> tree;
    std::vector<std::shared_ptr<const WaitingCell>> waiting;     // in the order they came
    std::vector<std::shared_ptr<const WaitingCell>> going_down;  // likewise, those before them
    std::uint64_t last_step = 0;                                 // when somebody came
    mutable std::optional<double> volume;  // cubic units; of what is there now, once asked for
    mutable std::shared_ptr<const Outlines> outlines;  // likewise, of a tile
    std::vector<std::pair<Origin, Taking>> taken;      // what is not in the books yet; cubic units

    // To change it: not what others see.
    BlockTree& own() {
        // Whoever let go of it has read it, perhaps in another thread: letting go of it, too, comes
        // after that, which the count alone does not tell.
        std::shared_ptr<BlockTree>(tree).reset();
        if (tree.use_count() > 1) tree = std::make_shared<BlockTree>(*tree);
        volume.reset();
        outlines.reset();
        return *tree;
    }
    // Lets no cell wait any longer. Drops the cells whose numbers are set in `forgotten`.
    void send_down(const std::vector<bool>& forgotten) {
        for (auto& cell : waiting) {
            const std::uint32_t number = cell->incoming.number;
            if (number >= forgotten.size() || !forgotten[number])
                going_down.push_back(std::move(cell));
        }
        waiting.clear();
    }
    // Takes in those that go down; into the books, if there are any.
    void settle(const AccountInput& input, bool keeps_account);
};

}  // namespace ncsim::cda
