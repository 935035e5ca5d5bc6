// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ledger of a program: the material that each block removed, the length of the path and the time.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// Motions of one execution of a block. Lengths in mm, volumes in mm³.
struct LedgerRow {
    std::uint32_t file = 0;
    std::uint32_t line = 0;
    std::uint64_t first_motion = 0, last_motion = 0;
    int tool = 0;
    /// Feed if any motion of the block is a feed move.
    gcode::MoveKind kind = gcode::MoveKind::Feed;
    double length_mm = 0.0;
    double removed_mm3 = 0.0;
    /// Time by the model of cycle_time.h; empty if a feed or a rapid rate is unknown.
    std::optional<double> seconds;
    /// Box that encloses the positions of the tool within the stock's box while material was
    /// removed; empty if none was.
    Box contact;
    /// Returns the removal rate in mm³/min; empty without a time.
    std::optional<double> removal_rate() const {
        if (!seconds || *seconds <= 0.0) return std::nullopt;
        return 60.0 * removed_mm3 / *seconds;
    }
};

/// Totals of a program, and the rows on request. Lengths in mm, volumes in mm³, times in s.
struct Ledger {
    std::vector<LedgerRow> rows;  ///< In the order of execution; only on request.
    double stock_mm3 = 0.0;
    double rest_mm3 = 0.0;     ///< Remaining volume of the part, measured independently.
    double removed_mm3 = 0.0;  ///< Sum over all motions, also without rows.
    bool measured = false;     ///< The volume of every motion was measured.
    double feed_mm = 0.0, rapid_mm = 0.0;
    double air_mm = 0.0;  ///< Part of `feed_mm` that removed nothing; valid if `air_known`.
    bool air_known = false;
    /// Times of feed moves, of rapids, and of dwells and tool changes; empty if a part is unknown.
    std::optional<double> feed_seconds, rapid_seconds, other_seconds;

    /// Returns |removed + rest - stock| / stock; a correct ledger differs from 0 only by rounding.
    double imbalance() const;
};

}  // namespace ncsim::verify
