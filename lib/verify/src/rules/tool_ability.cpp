// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules sideways-cut, tap-feed, tap-retract and drill-depth: motions that the kind of tool
// cannot make.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace ncsim::verify {

using gcode::MoveKind;

namespace {

// Returns an observation with the assumptions of the contact.
Occurrence seen(const Setup& setup, const Move& move, std::string message) {
    Occurrence s{std::move(message)};
    s.lasts = true;
    s.rests_on = guesses_of(setup, move);
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    return s;
}

std::string_view kind_name(const ToolFacts& tool) {
    return toolpath::name_of(tool.tool.kind);
}

}  // namespace

void judge_sideways(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || move.motion->kind != MoveKind::Feed || !move.is_move || !move.meets_material ||
        !toolpath::is_axial(tool->tool.kind) || is_turned(*move.motion))
        return;
    const auto is_aside = [](const cda::Vec3& way) {
        constexpr double kLeast = 1e-3;  // relative to the length of the path
        return way.x * way.x + way.y * way.y > kLeast * kLeast;
    };
    if (!is_aside(move.enters) && !is_aside(move.leaves)) return;
    log.add("sideways-cut", move,
            seen(setup, move,
                 fmt::format("T{} is a {} and is fed sideways through material", move.motion->tool,
                             kind_name(*tool))));
}

void judge_tap_feed(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || tool->tool.kind != toolpath::ToolKind::Tap || !tool->pitch ||
        move.hole_depth_mm <= 0.0 || move.motion->spindle_rpm <= 0.0)
        return;
    const auto feed = feed_of(move);
    if (!feed) return;
    // relative to the pitch; a tapping holder compensates this much
    constexpr double kTolerance = 0.01;
    const double pitch = *feed / move.motion->spindle_rpm;
    if (std::abs(pitch - *tool->pitch) <= kTolerance * *tool->pitch) return;
    Occurrence s = seen(setup, move,
                        fmt::format("T{} is a tap with a pitch of {:.4g} mm and is fed {:.4g} mm a "
                                    "revolution",
                                    move.motion->tool, *tool->pitch, pitch));
    s.quantity = Quantity{"feed", pitch, "mm/rev"};
    if (!setup.units_assumption.empty()) s.rests_on.emplace_back("units-guess");
    log.add("tap-feed", move, std::move(s));
}

void judge_tap_retract(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || tool->tool.kind != toolpath::ToolKind::Tap || !move.leaves_cut) return;
    const bool at_feed = move.motion->kind == MoveKind::Feed;
    if (at_feed && move.motion->spindle != *move.leaves_cut) return;
    log.add("tap-retract", move,
            seen(setup, move,
                 at_feed ? fmt::format("T{} is a tap and leaves its thread without the spindle "
                                       "reversed",
                                       move.motion->tool)
                         : fmt::format("T{} is a tap and leaves its thread at rapid",
                                       move.motion->tool)));
}

void judge_drill_depth(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    constexpr double kRounding = 1e-6;  // mm
    if (!tool || !tool->flute_length || move.hole_depth_mm <= *tool->flute_length + kRounding)
        return;
    Occurrence s = seen(setup, move,
                        fmt::format("T{} drills deeper than its flutes of {:.6g} mm: chips stay in "
                                    "the hole",
                                    move.motion->tool, *tool->flute_length));
    s.quantity = Quantity{"depth", move.hole_depth_mm, "mm"};
    log.add("drill-depth", move, std::move(s));
}

}  // namespace ncsim::verify
