// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules over-travel and rotary-over-travel.
#include "finding_log.h"
#include "rule_table.h"
#include "unknown_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ncsim::verify {

std::optional<std::string> needs_travel(const Setup& setup) {
    const auto& travel = setup.machine.travel;
    if (std::ranges::none_of(travel, [](const auto& t) { return t.has_value(); })) {
        return "no travels are specified (machine.toml, [travel])";
    }
    if (!setup.machine.work_zero) {
        return "the position of the work zero (G54) in the machine is not specified; only the "
               "length of the path was compared with the travels";
    }
    return std::nullopt;
}

namespace {

constexpr double kTravelRounding = 1e-9;  // 1 pm: rounding of sums of decimal fractions

// Returns the reasons for doubt about positions: a move in a system without a specified offset, or
// a move by increments from an unknown start, has an assumed end. Stock and tool do not matter.
std::vector<std::string_view> guesses_of_place(const Setup& setup, const Move& move) {
    std::vector<std::string_view> guesses = guesses_of(setup, move);
    std::erase_if(guesses, [](std::string_view reason) {
        return reason != "offset-guess" && reason != "start-unknown";
    });
    return guesses;
}

// Compares the length of the path with the travel if the work zero is unknown: a longer path does
// not fit for any zero.
void compare_path_length(const Setup& setup, const Move& move, FindingLog& log) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto& travel = setup.machine.travel[static_cast<std::size_t>(axis)];
        if (!travel) continue;
        const double way = move.way.size()[axis];
        const double beyond = way - (travel->max - travel->min);
        if (beyond <= kTravelRounding || way <= move.previous_path_box.size()[axis]) continue;
        Occurrence s{fmt::format("the way in {} is longer than the travel of {:.6g} mm",
                                 "XYZ"[axis], travel -> max - travel -> min)};
        s.lasts = true;
        s.quantity = Quantity{"by", beyond, "mm"};
        s.box = move.path;
        s.rests_on = guesses_of_place(setup, move);
        log.add("over-travel", move, std::move(s));
    }
}

}  // namespace

void judge_over_travel(const Setup& setup, const Move& move, FindingLog& log) {
    // Under tip control the path of the axes differs from the path of the tip.
    if (!move.is_move || (move.is_tilted_tip && !move.machine_path)) return;
    if (!move.machine_path) {
        compare_path_length(setup, move, log);
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto& travel = setup.machine.travel[static_cast<std::size_t>(axis)];
        if (!travel) continue;
        const double below = travel->min - move.machine_path->min[axis];
        const double above = move.machine_path->max[axis] - travel->max;
        if (below <= kTravelRounding && above <= kTravelRounding) continue;
        Occurrence s{fmt::format("{} runs beyond its {} end at {:.6g}", "XYZ"[axis],
                                 above > kTravelRounding ? "upper" : "lower",
                                 above > kTravelRounding ? travel->max : travel->min)};
        s.quantity = Quantity{"by", std::max(below, above), "mm"};
        s.box = move.path;
        s.rests_on = guesses_of_place(setup, move);
        // A sufficiently long tool keeps Z above its lower end.
        if (axis == 2 && above <= kTravelRounding && !move.ends_at_nose &&
            has_unknown_length(setup, move))
            s.rests_on.emplace_back("length-offset");
        if (move.motion->machine_coordinates && !setup.home_assumption.empty()) {
            s.assumptions.push_back("home: " + setup.home_assumption);
        }
        if (axis == 2 && move.length_offset == 0.0) {
            s.assumptions.emplace_back("tool length: 0, no offset is active (G43)");
        }
        log.add("over-travel", move, std::move(s));
    }
}

std::optional<std::string> needs_rotary_travel(const Setup& setup) {
    if (!setup.kinematics) return std::nullopt;
    std::string letters;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool has_axis = setup.kinematics->chain.find("ABC"[i]) != nullptr;
        if (has_axis && !setup.machine.rotary_travel[i])
            letters.append(letters.empty() ? "" : ", ").append(1, "ABC"[i]);
    }
    if (letters.empty()) return std::nullopt;
    return fmt::format("no travel of {} is specified (machine.toml, [travel])", letters);
}

void judge_rotary_over_travel(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.is_move) return;
    const gcode::Position& from = *gcode::start_of(*move.motion);
    const gcode::Position& to = *gcode::end_of(*move.motion);
    const std::array<std::array<double, 2>, 3> ends{{{from.a.degrees(), to.a.degrees()},
                                                     {from.b.degrees(), to.b.degrees()},
                                                     {from.c.degrees(), to.c.degrees()}}};
    constexpr double kRoundingDegrees = 1e-6;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& travel = setup.machine.rotary_travel[i];
        if (!travel) continue;
        // A position beyond the end is reported only for the motion that reached it.
        const double at = ends[i][1] + setup.machine.rotary_zero[i];
        const double before = ends[i][0] + setup.machine.rotary_zero[i];
        const double below = travel->min - at, above = at - travel->max;
        const double beyond = std::max(below, above);
        if (beyond <= kRoundingDegrees || at == before) continue;
        Occurrence s{fmt::format("{} runs beyond its {} end at {:.6g} degrees", "ABC"[i],
                                 above > below ? "upper" : "lower",
                                 above > below ? travel->max : travel->min)};
        s.quantity = Quantity{"by", beyond, "degrees"};
        s.box = move.path;
        log.add("rotary-over-travel", move, std::move(s));
    }
}

}  // namespace ncsim::verify
