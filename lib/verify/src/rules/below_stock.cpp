// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule below-stock: tools that go below the stock, where the table may be.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

std::optional<std::string> needs_stock(const Setup& setup) {
    if (!setup.stock) return "what is cut is not known";
    if (!setup.stock_assumption.empty()) return "the stock is derived from what is cut";
    return std::nullopt;
}

void judge_below_stock(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.is_move || !setup.stock || !setup.stock_assumption.empty()) return;
    // With rotary axes away from 0, the region below is at a different side of the stock.
    if (is_turned(*move.motion) || !toolpath::has_known_end(*move.motion)) return;
    if (!facts_of(setup, move.motion->tool)) return;
    const double floor = setup.stock->min.z - setup.machine.below_stock;
    const double below = floor - move.path.min.z;
    if (below <= 1e-9) return;  // 1 pm: rounding of sums of decimal fractions
    Occurrence s{setup.machine.below_stock > 0.0
                     ? fmt::format("goes deeper than the {:.6g} mm that are free below the stock",
                                   setup.machine.below_stock)
                     : "goes below the stock, where the table may be"};
    s.quantity = Quantity{"by", below, "mm"};
    s.box = move.path;
    s.assumptions = assumptions_of(setup, move);
    log.add("below-stock", move, std::move(s));
    log.doubt("below-stock", fmt::format("T{} goes below the stock", move.motion->tool),
              {move.motion->file, move.motion->span});
}

}  // namespace ncsim::verify
