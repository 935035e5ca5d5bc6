// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writer of the ledger, motion by motion. If steps are not measured, the account of the part gives
// the removed volume of each motion at the end.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/ledger.h"

#include "move.h"

#include <cstddef>
#include <vector>

namespace ncsim::verify {

class LedgerBook {
public:
    /// Creates a writer for `ledger`; `stock` in mm.
    /// Requires: `ledger` outlives the writer.
    LedgerBook(Ledger& ledger, const Box& stock) : ledger_(ledger), stock_(stock) {}

    /// Begins a motion.
    void begin() { cut_now_ = {}; }
    /// Notes the cells of a step of this motion. Rounding displaces the cells by at most `rounding`
    /// (mm).
    void note_cells(const toolpath::Step& step, double rounding);
    /// Ends the motion. `later`: the account will give the removed volume; otherwise `move` has it.
    void enter(const Move& move, bool later);
    /// Returns the row that a time belongs to.
    std::size_t row() const { return ledger_.rows.empty() ? 0 : ledger_.rows.size() - 1; }
    /// Enters the volumes of `account` after the last motion. `tells_air`: also sums up the feed
    /// moves that removed nothing.
    void close(const cda::RemovalByMotion& account, bool tells_air);

private:
    // Motion whose removed volume the account gives.
    struct Cut {
        std::size_t row = 0;
        cda::Origin origin = cda::kStockOrigin;
        double feed_mm = 0.0;
        // Upper bound (mm³) of the volume that the cells remove through rounding alone, where the
        // cutter was before.
        double sliver_mm3 = 0.0;
    };

    Ledger& ledger_;
    Box stock_;
    Cut cut_now_;
    std::vector<Cut> cuts_;
};

}  // namespace ncsim::verify
