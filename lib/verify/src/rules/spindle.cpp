// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules spindle-off, spindle-reversed, spindle-limit and feed-limit.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

using gcode::MoveKind;
using gcode::SpindleTurning;

namespace {

Occurrence material_occurrence(const Setup& setup, const Move& move, std::string message) {
    Occurrence s{std::move(message)};
    if (move.volume_known) s.quantity = Quantity{"removed", move.removed_mm3, "mm3"};
    s.sums = true;
    s.lasts = true;
    s.rests_on = guesses_of(setup, move);
    s.point = move.contact_point;
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    return s;
}

// Tighter of two limits, with the owner of the limit.
struct Limit {
    double value = 0.0;
    const char* limit_source = "machine";
};

std::optional<Limit> tighter_limit(std::optional<double> machine, std::optional<double> tool) {
    if (machine && (!tool || *machine <= *tool)) return Limit{*machine, "machine"};
    if (tool) return Limit{*tool, "tool"};
    return std::nullopt;
}

bool any_tool_specifies(const Setup& setup, std::optional<double> ToolFacts::*limit) {
    return std::ranges::any_of(setup.tools,
                               [limit](const auto& t) { return (t.second.*limit).has_value(); });
}

}  // namespace

void judge_spindle_off(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != MoveKind::Feed) return;
    const bool stopped = move.motion->spindle == SpindleTurning::Stopped;
    if (!stopped && move.motion->spindle_rpm > 0.0 && !move.motion->spindle_in_doubt)
        return log.end_row("spindle-off");
    if (!move.needs_contacts || !move.meets_material) return;
    if (stopped) {
        log.add(
            "spindle-off", move,
            material_occurrence(setup, move, "feed move into material with the spindle stopped"));
    } else if (move.motion->spindle_rpm <= 0.0) {
        log.add("spindle-off", move,
                material_occurrence(
                    setup, move, "feed move into material with the spindle on but no speed (S)"));
    } else {
        Occurrence s = material_occurrence(setup, move,
                                           "feed move into material after M0 or M1, which may "
                                           "have stopped the spindle");
        s.rests_on.emplace_back("spindle-after-stop");
        log.add("spindle-off", move, std::move(s));
    }
}

void judge_spindle_reversed(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != MoveKind::Feed) return;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    const bool left = tool && tool->left_hand;
    const auto wrong = left ? SpindleTurning::Clockwise : SpindleTurning::Counterclockwise;
    if (move.motion->spindle != wrong) {
        log.end_row("spindle-reversed");
        return;
    }
    if (!move.needs_contacts || !move.meets_material) return;
    Occurrence s =
        material_occurrence(setup, move,
                            left ? "left-handed tool cuts with the spindle clockwise (M3)"
                                 : "right-handed tool cuts with the spindle counter-clockwise "
                                   "(M4)");
    if (!left) s.assumptions.emplace_back("tool: right-handed, unless a job specifies otherwise");
    log.add("spindle-reversed", move, std::move(s));
}

std::optional<std::string> needs_speed_limit(const Setup& setup) {
    if (setup.machine.max_rpm || setup.machine.min_rpm ||
        any_tool_specifies(setup, &ToolFacts::max_rpm)) {
        return std::nullopt;
    }
    return "neither the machine nor a tool has a limit of the spindle speed";
}

void judge_spindle_limit(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != MoveKind::Feed || !move.is_move ||
        move.motion->spindle == SpindleTurning::Stopped || move.motion->spindle_rpm <= 0.0) {
        return;
    }
    const double rpm = move.motion->spindle_rpm;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    Occurrence s;
    s.lasts = true;
    s.quantity = Quantity{"speed", rpm, "rpm"};
    const auto most = tighter_limit(setup.machine.max_rpm, tool ? tool->max_rpm : std::nullopt);
    if (most && rpm > most->value) {
        s.message = fmt::format("spindle speed above the {}'s limit of {:.6g} rpm",
                                most->limit_source, most->value);
    } else if (setup.machine.min_rpm && rpm < *setup.machine.min_rpm) {
        s.message = fmt::format("spindle speed below the machine's least of {:.6g} rpm",
                                *setup.machine.min_rpm);
    } else {
        log.end_row("spindle-limit");
        return;
    }
    log.add("spindle-limit", move, std::move(s));
}

std::optional<std::string> needs_feed_limit(const Setup& setup) {
    if (setup.machine.max_feed || any_tool_specifies(setup, &ToolFacts::max_feed))
        return std::nullopt;
    return "neither the machine nor a tool has a limit of the feed";
}

void judge_feed_limit(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != MoveKind::Feed || !move.is_move) return;
    const auto feed = feed_of(move);
    if (!feed) return;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    const auto most = tighter_limit(setup.machine.max_feed, tool ? tool->max_feed : std::nullopt);
    if (!most || *feed <= most->value) {
        log.end_row("feed-limit");
        return;
    }
    Occurrence s{
        fmt::format("feed above the {}'s limit of {:.6g} mm/min", most->limit_source, most->value)};
    s.lasts = true;
    s.quantity = Quantity{"feed", *feed, "mm/min"};
    if (!setup.units_assumption.empty()) s.rests_on.emplace_back("units-guess");
    log.add("feed-limit", move, std::move(s));
}

}  // namespace ncsim::verify
