// SPDX-License-Identifier: GPL-3.0-or-later
//
// The books of a program: what each block took away, on which path and in which time.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// The motions that one execution of a block makes. Lengths mm, volumes mm³.
struct LedgerRow {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
    std::uint64_t first_motion = 0, last_motion = 0;
    int tool = 0;
    gcode::MoveKind kind = gcode::MoveKind::Feed;  ///< Feed, if any motion of the block is.
    double length_mm = 0.0;
    double removed_mm3 = 0.0;
    /// By the model of cycle_time.h; empty where feed or rapid rates are not known.
    std::optional<double> seconds;
    /// Encloses where the tool was in the stock's box while it removed something; empty: it did
    /// not.
    cda::Box contact;
    /// mm³/min; empty without a time.
    std::optional<double> removal_rate() const {
        if (!seconds || *seconds <= 0.0) return std::nullopt;
        return 60.0 * removed_mm3 / *seconds;
    }
};

struct Ledger {
    std::vector<LedgerRow> rows;  ///< In the order of execution; only if asked for.
    double stock_mm3 = 0.0;
    double rest_mm3 = 0.0;     ///< Of the part, measured on its own.
    double removed_mm3 = 0.0;  ///< Sum over the motions. Whether rows are kept or not.
    bool measured = false;     ///< Every motion was measured: the books can be closed.
    double feed_mm = 0.0, rapid_mm = 0.0;
    double air_mm = 0.0;  ///< Of feed_mm, what removed nothing; where `air_known`.
    bool air_known = false;
    /// Feed, rapid and the rest (dwells, tool changes); empty where some of it is not known.
    std::optional<double> feed_seconds, rapid_seconds, other_seconds;

    /// |removed + rest - stock| / stock: rounding alone, if all is well.
    double imbalance() const;
};

}  // namespace ncsim::verify
