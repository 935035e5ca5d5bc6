// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules about motions that the kind of tool cannot make: sideways-cut, tap-feed, tap-retract,
// drill-depth, thread-retract, countersink-depth, tip-cut and bar-retract.
#include "body.h"
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace ncsim::verify {

using gcode::MoveKind;

namespace {

// Returns an observation with the assumptions of the contact.
Occurrence contact_occurrence(const Setup& setup, const Move& move, std::string message) {
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
    const auto is_aside = [](const Vec3& way) {
        constexpr double kLeast = 1e-3;  // relative to the length of the path
        return way.x * way.x + way.y * way.y > kLeast * kLeast;
    };
    if (!is_aside(move.enters) && !is_aside(move.leaves)) return;
    log.add("sideways-cut", move,
            contact_occurrence(setup, move,
                               fmt::format("T{} is a {} and is fed sideways through material",
                                           move.motion->tool, kind_name(*tool))));
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
    Occurrence s = contact_occurrence(
        setup, move,
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
            contact_occurrence(
                setup, move,
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
    Occurrence s = contact_occurrence(
        setup, move,
        fmt::format("T{} drills deeper than its flutes of {:.6g} mm: chips stay in "
                    "the hole",
                    move.motion->tool, *tool->flute_length));
    s.quantity = Quantity{"depth", move.hole_depth_mm, "mm"};
    log.add("drill-depth", move, std::move(s));
}

bool is_oriented_bar(const Setup& setup, const Move& move) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    return tool && tool->tool.kind == toolpath::ToolKind::BoringBar &&
           move.motion->spindle_oriented;
}

void judge_bar_retract(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || tool->tool.kind != toolpath::ToolKind::BoringBar || !move.meets_material ||
        move.motion->kind != MoveKind::Rapid)
        return;
    const bool is_oriented = move.motion->spindle_oriented;
    const bool is_aside = move.motion->steps_aside.value_or(!move.has_cut_below);
    if (is_oriented && is_aside) {
        log.doubt("not-simulated",
                  fmt::format("T{} is a boring bar with an oriented stop in material: whether its "
                              "edge clears the bore is not simulated",
                              move.motion->tool),
                  {move.motion->file, move.motion->span});
        return;
    }
    const bool goes_up = move.leaves.z > 0.0 && move.leaves.x == 0.0 && move.leaves.y == 0.0;
    if (!is_oriented && !goes_up) return;
    log.add("bar-retract", move,
            contact_occurrence(
                setup, move,
                is_oriented ? fmt::format("T{} is a boring bar and goes through a bore narrower "
                                          "than itself without a step aside",
                                          move.motion->tool)
                            : fmt::format("T{} is a boring bar and goes back through a bore "
                                          "narrower than itself without an oriented stop",
                                          move.motion->tool)));
}

void judge_thread_retract(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.is_at_wall || !move.has_threaded) return;
    log.add("thread-retract", move,
            contact_occurrence(
                setup, move,
                fmt::format("T{} is a thread mill and goes up while it is in the wall of its "
                            "thread",
                            move.motion->tool)));
}

void judge_countersink_depth(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || tool->tool.kind != toolpath::ToolKind::Countersink) return;
    const double radius = toolpath::cutting_diameter_of(tool->tool) / 2;
    double cone = 0.0;  // height
    for (const toolpath::ProfilePoint& p : tool->tool.pieces.front().profile) {
        cone = p.height;
        if (p.radius >= radius) break;
    }
    constexpr double kRounding = 2 * kRaiseStep;
    if (move.hole_depth_mm <= cone + kRounding) return;
    Occurrence s = contact_occurrence(
        setup, move,
        fmt::format("T{} is a countersink and goes deeper than its cone, which is "
                    "{:.6g} mm high",
                    move.motion->tool, cone));
    s.quantity = Quantity{"depth", move.hole_depth_mm, "mm"};
    log.add("countersink-depth", move, std::move(s));
}

void judge_tip_cut(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.tip_cuts) return;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    log.add("tip-cut", move,
            contact_occurrence(
                setup, move,
                fmt::format("the flat tip of T{} (D{:.6g}), which has no edges, goes sideways "
                            "through material",
                            move.motion->tool, tool->flat_tip.value_or(0.0))));
}

}  // namespace ncsim::verify
