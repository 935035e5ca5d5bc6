// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule plunge: tools that do not cut at the centre must not descend on material.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

void judge_plunge(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.plunged_mm <= 0.0) return;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    Occurrence s{fmt::format("T{} goes down into material and does not cut at its centre (D{:.6g})",
                             move.motion->tool, tool->blind_diameter.value_or(0.0))};
    s.quantity = Quantity{"down", move.plunged_mm, "mm"};
    s.rests_on = guesses_of(setup, move);
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    if (!tool->blind_assumption.empty()) s.assumptions.push_back("tool: " + tool->blind_assumption);
    log.add("plunge", move, std::move(s));
}

}  // namespace ncsim::verify
