// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule air-cut.
#include "air_cut.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::verify {

namespace {

// Largest number of line ranges in the message; the ledger lists all.
constexpr std::size_t kRangesShown = 8;

}  // namespace

std::optional<std::string> needs_air_cuts(const Setup& setup) {
    if (auto reason = needs_simulation(setup)) return reason;
    if (setup.air_cuts || setup.ledger) return std::nullopt;
    return "feed moves that remove nothing are looked for where they are asked for (--air-cuts)";
}

void AirCuts::take(const Move& move) {
    if (move.motion->kind != gcode::MoveKind::Feed || !move.is_traced || !move.needs_contacts)
        return;
    ++blocks_;
    feed_mm_ += move.length_mm;
    const bool air = !move.meets_material && move.length_mm > 0.0;
    if (air) {
        air_mm_ += move.length_mm;
        const std::uint32_t line = move.motion->span.line;
        if (air_blocks_++ == 0) {
            first_.place = {move.motion->file, move.motion->span};
            first_.first_motion = move.number;
            first_.tool = move.motion->tool;
        }
        first_.last = {move.motion->file, move.motion->span};
        first_.last_motion = move.number;
        if (was_air_ && !ranges_.empty() && ranges_more_ == 0) {
            ranges_.back().last = line;
        } else if (!was_air_ && ranges_.size() < kRangesShown) {
            ranges_.push_back({line, line});
        } else if (!was_air_) {
            ++ranges_more_;
        }
        first_.box.add(move.path);
    }
    was_air_ = air;
}

void AirCuts::conclude(const Setup& setup, FindingLog& log) const {
    if (air_blocks_ == 0) return;
    std::string where;
    for (const Lines& r : ranges_) {
        where += fmt::format("{}{}", where.empty() ? "" : ", ", r.first);
        if (r.last != r.first) where += fmt::format("-{}", r.last);
    }
    if (ranges_more_ > 0) where += fmt::format(" and {} more places", ranges_more_);
    Finding f = first_;
    f.rule = "air-cut";
    f.severity = Severity::Note;
    f.count = air_blocks_;
    f.message =
        fmt::format("{} of {} feed moves remove nothing, at lines {}", air_blocks_, blocks_, where);
    f.quantity = Quantity{"share of the feed path", 100.0 * air_mm_ / feed_mm_, "%"};
    std::vector<std::string_view> rests_on;
    if (!setup.stock_assumption.empty()) {
        f.assumptions.push_back("stock: " + setup.stock_assumption);
        rests_on.emplace_back("stock-guess");
    }
    log.add(std::move(f), std::move(rests_on));
}

}  // namespace ncsim::verify
