// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools that do not cut at their centre, going straight down into material.
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

void judge_plunge(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.plunges || move.blind_mm3 <= 0.0) return;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    Sighting s{fmt::format("T{} plunges into material and does not cut at its centre (D{:.6g})",
                           move.motion->tool, tool->blind_diameter.value_or(0.0))};
    s.quantity = Quantity{"under the centre", move.blind_mm3, "mm3"};
    s.sums = true;
    s.weakened = rests_on_guesses(setup, move) || !tool->blind_assumption.empty();
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    if (!tool->blind_assumption.empty()) s.assumptions.push_back("tool: " + tool->blind_assumption);
    log.add("plunge", move, std::move(s));
}

}  // namespace ncsim::verify
