// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of the stock: the block's tree, share of the volume, and waiting cells.
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

// A cell that some blocks have not inserted yet.
struct PendingCell {
    Cell cell;
    IncomingCell incoming;
};

// A part of the tree with a share of the volume.
struct Block {
    std::shared_ptr<BlockTree> tree;
    std::vector<std::shared_ptr<const PendingCell>> pending;  // in order of arrival
    // cells in insertion, in order of arrival; all arrived before `pending`
    std::vector<std::shared_ptr<const PendingCell>> inserting;
    std::uint64_t last_step = 0;           // step of the last arrival
    std::uint64_t changes = 0;             // number of calls of own()
    mutable std::optional<double> volume;  // volume of `tree`, cubic units; empty until requested
    // surface in `tree`; null until requested; only for a tile
    mutable std::shared_ptr<const Outlines> outlines;
    std::vector<std::pair<Origin, RemovedVolume>>
        removed_volumes;  // amounts not yet in the account; cubic units

    // Returns the tree for modification; copies the tree if other parts share the tree.
    BlockTree& own() {
        // Another thread may have read and released the tree. Releasing a reference orders those
        // reads before this write; a look at the count alone does not.
        std::shared_ptr<BlockTree>(tree).reset();
        if (tree.use_count() > 1) tree = std::make_shared<BlockTree>(*tree);
        ++changes;
        volume.reset();
        outlines.reset();
        return *tree;
    }
    // Moves all waiting cells to `inserting`. Drops the cells whose numbers are set in
    // `superseded`.
    void start_insertion(const std::vector<bool>& superseded) {
        for (auto& cell : pending) {
            const std::uint32_t number = cell->incoming.number;
            if (number >= superseded.size() || !superseded[number])
                inserting.push_back(std::move(cell));
        }
        pending.clear();
    }
    // Inserts the cells of `inserting`; adds the removed volumes to `removed_volumes` if
    // `keeps_account`.
    void settle(const AccountInput& input, bool keeps_account);
};

}  // namespace ncsim::cda
