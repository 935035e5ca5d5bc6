// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule rapid-in-material, and the assumptions on which every contact with the part rests.
#include "ncsim/gcode/state.h"

#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

const ToolFacts* facts_of(const Setup& setup, int tool) {
    const auto found = setup.tools.find(tool);
    return found == setup.tools.end() ? nullptr : &found->second;
}

std::optional<std::string> needs_nothing(const Setup&) {
    return std::nullopt;
}

std::optional<std::string> needs_simulation(const Setup& setup) {
    if (setup.not_simulated) return "the program was not simulated: " + *setup.not_simulated;
    return std::nullopt;
}

std::optional<std::string> needs_counting(const Setup& setup) {
    if (auto reason = needs_simulation(setup)) return reason;
    if (setup.pieces_counted) return std::nullopt;
    return "pieces are counted where they are asked for (--cut-free)";
}

namespace {

bool is_turned_at(const gcode::Position* p) {
    return p && (p->a.radians() != 0.0 || p->b.radians() != 0.0 || p->c.radians() != 0.0);
}

}  // namespace

bool is_turned(const gcode::Motion& motion) {
    return is_turned_at(gcode::start_of(motion)) || is_turned_at(gcode::end_of(motion));
}

std::string kinematics_guess(const Setup& setup, const Move& move) {
    const gcode::Motion& motion = *move.motion;
    if (!is_turned(motion)) return {};
    const bool of_tip = motion.coordinates == gcode::Coordinates::Tip;
    std::string guess = of_tip ? setup.tip_guess : setup.axes_guess;
    const auto add = [&guess](std::string_view what) {
        guess.append(guess.empty() ? "" : "; ").append(what);
    };
    const bool has_length = move.length_register != gcode::kNoLength && move.length_specified;
    if (!of_tip && setup.kinematics && setup.kinematics->chain.has_head() && !has_length) {
        add(fmt::format(
            "the head turns a tool of {:g} mm, a length that is not specified (G43, tool "
            "table)",
            motion.length.mm()));
    }
    if (of_tip && setup.rapid.dog_leg && motion.kind == gcode::MoveKind::Rapid)
        add("under tip control rapid moves are straight");
    return guess;
}

std::vector<std::string> assumptions_of(const Setup& setup, const Move& move) {
    std::vector<std::string> all;
    const ToolFacts* tool = facts_of(setup, move.motion->tool);
    if (!setup.stock_assumption.empty()) all.push_back("stock: " + setup.stock_assumption);
    if (tool && !tool->assumption.empty()) all.push_back("tool: " + tool->assumption);
    if (!setup.units_assumption.empty()) all.push_back("units: " + setup.units_assumption);
    if (move.motion->machine_coordinates && !setup.home_assumption.empty()) {
        all.push_back("home: " + setup.home_assumption);
    }
    if (const std::string guess = kinematics_guess(setup, move); !guess.empty())
        all.push_back("kinematics: " + guess);
    if (move.after_probe) {
        all.emplace_back("probe: it met something at its target; what follows may stand on that");
    }
    if (move.motion->kind == gcode::MoveKind::Rapid) {
        all.emplace_back(setup.rapid.dog_leg
                             ? "path: each axis moves at its own rapid rate (--rapid dog-leg)"
                             : "path: rapid moves are straight (--rapid linear)");
    }
    return all;
}

std::vector<std::string_view> guesses_of(const Setup& setup, const Move& move,
                                         Certainty certainty) {
    std::vector<std::string_view> reasons;
    const gcode::Motion& motion = *move.motion;
    const ToolFacts* tool = facts_of(setup, motion.tool);
    if (!setup.stock_assumption.empty()) reasons.emplace_back("stock-guess");
    if (tool && tool->is_guess) reasons.emplace_back("tool-guess");
    if (motion.start_assumed) reasons.emplace_back("start-unknown");
    if (move.after_probe) reasons.emplace_back("probe-guess");
    if (motion.offset_unknown || (motion.machine_coordinates && !setup.home_assumption.empty())) {
        reasons.emplace_back("offset-guess");
    }
    if (!kinematics_guess(setup, move).empty()) reasons.emplace_back("kinematics-guess");
    if (certainty == Certainty::Within) reasons.emplace_back("uncertain-contact");
    return reasons;
}

void judge_rapid_in_material(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.motion->kind != gcode::MoveKind::Rapid || !move.meets_material) return;
    if (is_oriented_bar(setup, move)) return;  // judged by bar-retract
    Occurrence s{move.arrives ? "rapid move ends in material, wherever it comes from"
                              : "rapid move through material"};
    if (move.volume_known) s.quantity = Quantity{"removed", move.removed_mm3, "mm3"};
    s.sums = true;
    s.certainty = move.certainty;
    s.rests_on = guesses_of(setup, move, move.certainty);
    s.point = move.contact_point;
    s.box = move.contact;
    s.assumptions = assumptions_of(setup, move);
    log.add("rapid-in-material", move, std::move(s));
}

}  // namespace ncsim::verify
