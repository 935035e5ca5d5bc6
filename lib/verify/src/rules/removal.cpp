// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules depth-limit, engagement-limit and removal-rate.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

namespace {

std::optional<std::string> needs_limit(const Setup& setup, std::optional<double> ToolFacts::*limit,
                                       const char* what) {
    if (auto reason = needs_simulation(setup)) return reason;
    if (std::ranges::any_of(setup.tools,
                            [limit](const auto& t) { return (t.second.*limit).has_value(); })) {
        return std::nullopt;
    }
    return fmt::format("no tool has a limit of its {}", what);
}

Occurrence limit_occurrence(const Setup& setup, const Move& move, std::string message,
                            Quantity quantity) {
    Occurrence s{std::move(message)};
    s.quantity = std::move(quantity);
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    s.rests_on = guesses_of(setup, move);
    return s;
}

bool cuts_at_feed(const Move& move) {
    return move.motion->kind == gcode::MoveKind::Feed && move.meets_material;
}

}  // namespace

std::optional<std::string> needs_depth_limit(const Setup& setup) {
    return needs_limit(setup, &ToolFacts::max_depth, "depth of cut");
}

std::optional<std::string> needs_engagement_limit(const Setup& setup) {
    return needs_limit(setup, &ToolFacts::max_engagement, "engagement");
}

std::optional<std::string> needs_removal_limit(const Setup& setup) {
    return needs_limit(setup, &ToolFacts::max_removal_rate, "removal rate");
}

void judge_depth(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != gcode::MoveKind::Feed || move.too_deep_mm <= 0.0) return;
    const double limit = *facts_of(setup, move.motion->tool)->max_depth;
    log.add("depth-limit", move,
            limit_occurrence(setup, move,
                             fmt::format("depth of cut above the tool's limit of {:.6g} mm", limit),
                             {"depth", limit + move.too_deep_mm, "mm"}));
}

void judge_engagement(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || !tool->max_engagement || !cuts_at_feed(move) || !move.volume_known) return;
    if (move.length_mm <= 0.0) return;
    const double engagement = move.removed_mm3 / move.length_mm;
    if (engagement <= *tool->max_engagement) return;
    log.add(
        "engagement-limit", move,
        limit_occurrence(setup, move,
                         fmt::format("material per path above the tool's limit of {:.6g} mm3/mm",
                                     *tool->max_engagement),
                         {"engagement", engagement, "mm3/mm"}));
}

void judge_removal_rate(const Setup& setup, const Move& move, FindingLog& log) {
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!tool || !tool->max_removal_rate || !cuts_at_feed(move) || !move.volume_known) return;
    const auto feed = feed_of(move);
    if (!feed) return;
    const double rate = move.removed_mm3 / move.length_mm * *feed;
    if (rate <= *tool->max_removal_rate) return;
    log.add("removal-rate", move,
            limit_occurrence(setup, move,
                             fmt::format("removal rate above the tool's limit of {:.6g} mm3/min",
                                         *tool->max_removal_rate),
                             {"removal rate", rate, "mm3/min"}));
}

}  // namespace ncsim::verify
