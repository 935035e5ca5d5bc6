// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule start-unknown: a move with an unknown start removes no material and is not verified.
#include "finding_log.h"
#include "rule_table.h"

namespace ncsim::verify {

void judge_start_unknown(const Setup&, const Move& move, FindingLog& log) {
    if (!move.is_move || move.passes_above || toolpath::has_known_start(*move.motion)) return;
    const bool rapid = move.motion->kind == gcode::MoveKind::Rapid;
    Occurrence s{rapid
                     ? "this rapid move starts at an unknown position; it was not verified"
                     : "this feed move starts at an unknown position; it cuts nothing and was not "
                       "verified"};
    // Every program begins with an unknown start: only a cut from there deserves a warning.
    s.is_note = rapid;
    log.add("start-unknown", move, std::move(s));
}

}  // namespace ncsim::verify
