// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule no-feed: every feed move needs a feed.
#include "finding_log.h"
#include "rule_table.h"

namespace ncsim::verify {

std::optional<double> feed_of(const Move& move) {
    const gcode::Motion& m = *move.motion;
    if (m.feed <= 0.0 || move.length_mm <= 0.0) return std::nullopt;
    switch (m.feed_mode) {
        case gcode::FeedMode::PerMinute: return m.feed;
        case gcode::FeedMode::InverseTime: return m.feed * move.length_mm;
        case gcode::FeedMode::PerRevolution: break;
    }
    if (m.spindle_rpm <= 0.0) return std::nullopt;
    return m.feed * m.spindle_rpm;
}

void judge_no_feed(const Setup&, const Move& move, FindingLog& log) {
    if (move.motion->kind != gcode::MoveKind::Feed || !move.is_move) return;
    if (move.motion->feed > 0.0) {
        log.end_row("no-feed");
        return;
    }
    Occurrence s{"feed move without a feed: no F was given in this feed mode"};
    s.lasts = true;
    s.sums = true;
    s.quantity = Quantity{"path", move.length_mm, "mm"};
    log.add("no-feed", move, std::move(s));
}

}  // namespace ncsim::verify
