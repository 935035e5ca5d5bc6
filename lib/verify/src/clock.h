// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clock that adds up the time of a program, by row of the ledger, if feeds and rates are known.
#pragma once

#include "ncsim/verify/ledger.h"

#include "cycle_time.h"
#include "move.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::verify {

class Clock {
public:
    explicit Clock(const MachineDescription& machine);

    /// Adds a move; `row` is the index of the move's row in the ledger.
    void take(const Move& move, std::size_t row);
    /// Adds a dwell or a tool change.
    void rest(const gcode::Motion& motion, std::size_t row);
    /// Writes the times into the existing rows, and the sums.
    void finish(Ledger& ledger);

private:
    void add(std::size_t row, std::optional<double> seconds);
    std::optional<double> speed_of(const Move& move) const;

    const MachineDescription* machine_;
    double feed_seconds_ = 0.0, rapid_seconds_ = 0.0, other_seconds_ = 0.0;
    bool feed_known_ = true, rapid_known_ = true, other_known_ = true;
    std::vector<std::optional<double>> rows_;
    MotionPlanner planner_;
};

}  // namespace ncsim::verify
