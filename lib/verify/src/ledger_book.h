// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the rows of the ledger, motion by motion. Where no step is measured, the account of the
// part tells in the end what each of them removed.
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
    /// `ledger` must outlive it; `stock` in mm.
    LedgerBook(Ledger& ledger, const cda::Box& stock) : ledger_(ledger), stock_(stock) {}

    /// A motion begins.
    void begin() { cut_now_ = {}; }
    /// What the motion at hand takes away, if it does. The cells lie off by `rounding` (mm) at
    /// most.
    void note_cells(const toolpath::Step& step, double rounding);
    /// The motion ends. `later`: the account tells what it removed; else `move` does.
    void enter(const Move& move, bool later);
    /// The row that a time belongs to.
    std::size_t row() const { return ledger_.rows.empty() ? 0 : ledger_.rows.size() - 1; }
    /// After the last motion. `tells_air`: feed moves that removed nothing are counted, too.
    void close(const cda::Account& account, bool tells_air);

private:
    // The account tells the rest.
    struct Cut {
        std::size_t row = 0;
        cda::Origin origin = cda::kStockOrigin;
        double feed_mm = 0.0;
        // What cells take that are where the cutter was before, but for rounding, at most.
        double sliver_mm3 = 0.0;
    };

    Ledger& ledger_;
    cda::Box stock_;
    Cut cut_now_;
    std::vector<Cut> cuts_;
};

}  // namespace ncsim::verify
