// SPDX-License-Identifier: GPL-3.0-or-later
//
// The working part of the rules. One file a subject under rules/; the table that makes them known
// is rule.cpp.
#pragma once

#include "ncsim/verify/rule_info.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
struct Motion;
}

namespace ncsim::verify {

class FindingLog;
struct Move;
struct Setup;
struct ToolFacts;

struct Rule {
    RuleInfo info;
    bool of_part = false;  ///< Looks at the part or at what stands around it.
    /// Why it cannot be asked with this setup; nothing: it can.
    std::optional<std::string> (*missing)(const Setup&) = nullptr;
    /// Looks at one motion. Null for rules that look at the whole, or at diagnostics.
    void (*judge)(const Setup&, const Move&, FindingLog&) = nullptr;
};

std::span<const Rule> rule_table();

/// For geometric rules: why the program was not simulated.
std::optional<std::string> needs_simulation(const Setup& setup);
std::optional<std::string> needs_nothing(const Setup& setup);
std::optional<std::string> needs_counting(const Setup& setup);
std::optional<std::string> needs_design(const Setup& setup);
std::optional<std::string> needs_travel(const Setup& setup);
std::optional<std::string> needs_rotary_travel(const Setup& setup);
std::optional<std::string> needs_fixtures(const Setup& setup);
std::optional<std::string> needs_bodies(const Setup& setup);
std::optional<std::string> needs_feed_limit(const Setup& setup);
std::optional<std::string> needs_speed_limit(const Setup& setup);
std::optional<std::string> needs_depth_limit(const Setup& setup);
std::optional<std::string> needs_engagement_limit(const Setup& setup);
std::optional<std::string> needs_removal_limit(const Setup& setup);
std::optional<std::string> needs_air_cuts(const Setup& setup);
std::optional<std::string> needs_stock(const Setup& setup);
std::optional<std::string> needs_links(const Setup& setup);
std::optional<std::string> needs_clearance(const Setup& setup);
std::optional<std::string> needs_path_deviation(const Setup& setup);

void judge_rapid_in_material(const Setup&, const Move&, FindingLog&);
void judge_spindle_off(const Setup&, const Move&, FindingLog&);
void judge_spindle_reversed(const Setup&, const Move&, FindingLog&);
void judge_spindle_limit(const Setup&, const Move&, FindingLog&);
void judge_no_feed(const Setup&, const Move&, FindingLog&);
void judge_feed_limit(const Setup&, const Move&, FindingLog&);
void judge_non_cutting(const Setup&, const Move&, FindingLog&);
void judge_plunge(const Setup&, const Move&, FindingLog&);
void judge_depth(const Setup&, const Move&, FindingLog&);
void judge_engagement(const Setup&, const Move&, FindingLog&);
void judge_removal_rate(const Setup&, const Move&, FindingLog&);
void judge_fixture_contact(const Setup&, const Move&, FindingLog&);
void judge_fixture_clearance(const Setup&, const Move&, FindingLog&);
void judge_over_travel(const Setup&, const Move&, FindingLog&);
void judge_rotary_over_travel(const Setup&, const Move&, FindingLog&);
void judge_clamps(const Setup&, const Move&, FindingLog&);
void judge_singular_pose(const Setup&, const Move&, FindingLog&);
void judge_path_deviation(const Setup&, const Move&, FindingLog&);
void judge_start_unknown(const Setup&, const Move&, FindingLog&);
void judge_path_accuracy(const Setup&, const Move&, FindingLog&);
void judge_below_stock(const Setup&, const Move&, FindingLog&);
void judge_machine_collision(const Setup&, const Move&, FindingLog&);
void judge_machine_near_miss(const Setup&, const Move&, FindingLog&);
void judge_length_offset(const Setup&, const Move&, FindingLog&);
void judge_sideways(const Setup&, const Move&, FindingLog&);
void judge_tap_feed(const Setup&, const Move&, FindingLog&);
void judge_tap_retract(const Setup&, const Move&, FindingLog&);
void judge_drill_depth(const Setup&, const Move&, FindingLog&);
void judge_bar_retract(const Setup&, const Move&, FindingLog&);
void judge_thread_retract(const Setup&, const Move&, FindingLog&);
void judge_countersink_depth(const Setup&, const Move&, FindingLog&);
void judge_tip_cut(const Setup&, const Move&, FindingLog&);

/// The rule that a diagnostic of this code belongs to; empty: another rule tells it better.
std::string_view rule_of_diagnostic(std::string_view code);

/// The reason for doubt that a warning of this code is; empty: none.
std::string_view doubt_of_diagnostic(std::string_view code);

/// What a contact with the part in this motion rests on: stock, tool, units, home, path.
std::vector<std::string> assumptions_of(const Setup& setup, const Move& move);
/// The reasons for doubt (ids) that it rests on: with any of them it is a warning.
std::vector<std::string_view> guesses_of(const Setup& setup, const Move& move,
                                         Certainty certainty = Certainty::Certain);
/// What nobody told of how the machine turns, in words; empty: nothing, or it does not turn.
std::string kinematics_guess(const Setup& setup, const Move& move);
/// True if a boring bar moves while the spindle is held in a direction.
bool is_oriented_bar(const Setup& setup, const Move& move);
/// Do rotary axes stand anywhere but at 0?
bool is_turned(const gcode::Motion& motion);
/// Why what `requirement` names is not told; nothing if it is.
std::optional<std::string> missing_requirement(const Setup& setup, std::string_view requirement);

/// mm/min, whatever the feed mode; empty if no feed was set or it moves nothing.
std::optional<double> feed_of(const Move& move);
const ToolFacts* facts_of(const Setup& setup, int tool);

}  // namespace ncsim::verify
