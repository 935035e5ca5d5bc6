// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves that come from nowhere leave no trace, and are not verified.
#include "finding_log.h"
#include "rule_table.h"

namespace ncsim::verify {

void judge_start_unknown(const Setup&, const Move& move, FindingLog& log) {
    if (!move.is_move || move.passes_above || toolpath::has_known_start(*move.motion)) return;
    const bool rapid = move.motion->kind == gcode::MoveKind::Rapid;
    Sighting s{rapid ? "this rapid move starts at an unknown position; it was not verified"
                     : "this feed move starts at an unknown position; it cuts nothing and was not "
                       "verified"};
    // Every program begins somewhere: only cutting from there is worth a warning.
    s.is_note = rapid;
    log.add("start-unknown", move, std::move(s));
}

}  // namespace ncsim::verify
