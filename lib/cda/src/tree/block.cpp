// SPDX-License-Identifier: GPL-3.0-or-later
//
// Insertion of a block's waiting cells.
#include "tree/block.h"

#include <algorithm>

namespace ncsim::cda {

void Block::settle(const AccountInput& input, bool keeps_account) {
    std::vector<const IncomingCell*> cells;
    cells.reserve(inserting.size());
    for (const auto& cell : inserting)
        cells.push_back(&cell->incoming);
    if (keeps_account) {
        std::vector<RemovedByTurn> turns;
        tree->account(cells, input, turns);
        for (const RemovedByTurn& turn : turns) {
            RemovedVolume taking{turn.volume, {}};
            for (const std::uint32_t number : turn.cells) {
                const auto cell = std::ranges::lower_bound(
                    inserting, number, {}, [](const auto& w) { return w->incoming.number; });
                taking.bounds.add(turn.step ? (*cell)->cell.steps->steps[*turn.step].bounds
                                            : (*cell)->cell.bounds);
            }
            removed_volumes.emplace_back(turn.origin, taking);
        }
    }
    own().insert(cells, input.cells, input.leaf);
    inserting.clear();
}

}  // namespace ncsim::cda
