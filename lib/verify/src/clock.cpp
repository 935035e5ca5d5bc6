// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds up the time of a program.
#include "clock.h"

#include "ncsim/toolpath/trace.h"

#include "rule_table.h"

#include <algorithm>
#include <cmath>

namespace ncsim::verify {

namespace {

// Returns the key of the planner: the row, and whether the move is a rapid.
std::size_t key_of(std::size_t row, bool rapid) {
    return 2 * row + (rapid ? 1 : 0);
}

}  // namespace

Clock::Clock(const MachineDescription& machine)
    : machine_(&machine),
      planner_(machine.junction_deviation, [this](std::size_t key, double seconds) {
          (key % 2 == 1 ? rapid_seconds_ : feed_seconds_) += seconds;
          add(key / 2, seconds);
      }) {}

// Adds to a row; a row with an unknown part is unknown.
void Clock::add(std::size_t row, std::optional<double> seconds) {
    if (rows_.size() <= row) rows_.resize(row + 1, 0.0);
    if (!rows_[row]) return;
    if (seconds) {
        *rows_[row] += *seconds;
    } else {
        rows_[row].reset();
    }
}

std::optional<double> Clock::speed_of(const Move& move) const {
    if (move.motion->kind == gcode::MoveKind::Rapid) {
        return rapid_speed_along(*machine_, move.enters);
    }
    const auto feed = feed_of(move);
    if (!feed) return std::nullopt;
    return (machine_->max_feed ? std::min(*feed, *machine_->max_feed) : *feed) / 60.0;
}

void Clock::take(const Move& move, std::size_t row) {
    if (move.length_mm <= 0.0) {
        // If the start is unknown, the row has no time. The sums contain the remaining moves.
        if (!toolpath::has_known_start(*move.motion)) add(row, std::nullopt);
        return;
    }
    const bool rapid = move.motion->kind == gcode::MoveKind::Rapid;
    const auto speed = speed_of(move);
    if (!speed) {
        (rapid ? rapid_known_ : feed_known_) = false;
        planner_.stop();
        add(row, std::nullopt);
        return;
    }
    PlannedMove planned;
    planned.length_mm = move.length_mm;
    planned.speed = *speed;
    const double first = acceleration_along(*machine_, move.enters);
    const double last = acceleration_along(*machine_, move.leaves);
    planned.acceleration = std::min(first, last);
    if (move.radius_mm > 0.0 && planned.acceleration > 0.0) {
        planned.speed = std::min(planned.speed, std::sqrt(planned.acceleration * move.radius_mm));
    }
    planned.enters = move.enters;
    planned.leaves = move.leaves;
    planned.stops = rapid;
    planned.key = key_of(row, rapid);
    planner_.add(planned);
}

void Clock::rest(const gcode::Motion& motion, std::size_t row) {
    planner_.stop();
    if (const auto* dwell = std::get_if<gcode::Dwell>(&motion.action)) {
        other_seconds_ += dwell->seconds;
        add(row, dwell->seconds);
    } else if (machine_->tool_change_seconds) {
        other_seconds_ += *machine_->tool_change_seconds;
    } else {
        other_known_ = false;
    }
}

void Clock::finish(Ledger& ledger) {
    planner_.stop();
    if (feed_known_) ledger.feed_seconds = feed_seconds_;
    if (rapid_known_) ledger.rapid_seconds = rapid_seconds_;
    if (other_known_) ledger.other_seconds = other_seconds_;
    for (std::size_t i = 0; i < ledger.rows.size() && i < rows_.size(); ++i)
        ledger.rows[i].seconds = rows_[i];
}

}  // namespace ncsim::verify
