// SPDX-License-Identifier: GPL-3.0-or-later
//
// Working part of the rules: one file a subject in rules/. The table of all rules is in rule.cpp.
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
    bool of_part = false;  ///< The rule needs the part or the bodies around the part.
    /// Returns the reason why the rule cannot be checked with this setup; empty: it can.
    std::optional<std::string> (*missing)(const Setup&) = nullptr;
    /// Judges one motion. Null for rules about the whole program or about diagnostics.
    void (*judge)(const Setup&, const Move&, FindingLog&) = nullptr;
};

std::span<const Rule> rule_table();

/// Returns the reason why the program was not simulated, for geometric rules.
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

/// Returns the rule of a diagnostic with this code; empty: a different rule or a doubt reports the
/// fault.
std::string_view rule_of_diagnostic(std::string_view code);

/// Returns the reason for doubt that a warning with this code is; empty: none.
std::string_view doubt_of_diagnostic(std::string_view code);

/// Returns the assumptions about stock, tool, units, home and path on which a contact with the part
/// in this motion rests.
std::vector<std::string> assumptions_of(const Setup& setup, const Move& move);
/// Returns the reasons for doubt (ids) on which a contact in this motion rests. A finding with such
/// a reason is a warning.
std::vector<std::string_view> guesses_of(const Setup& setup, const Move& move,
                                         Certainty certainty = Certainty::Certain);
/// Returns a description of the kinematics that is assumed for this motion; empty: no assumption,
/// or no rotary axis is away from 0.
std::string kinematics_guess(const Setup& setup, const Move& move);
/// True if a boring bar moves while the spindle is held in a direction.
bool is_oriented_bar(const Setup& setup, const Move& move);
/// True if a rotary axis is away from 0 at the start or the end of the motion.
bool is_turned(const gcode::Motion& motion);
/// Returns the text about a missing value that `requirement` demands; empty: the value is
/// specified.
std::optional<std::string> missing_requirement(const Setup& setup, std::string_view requirement);

/// Returns the feed in mm/min, for every feed mode; empty without a feed or a path.
std::optional<double> feed_of(const Move& move);
const ToolFacts* facts_of(const Setup& setup, int tool);

}  // namespace ncsim::verify
