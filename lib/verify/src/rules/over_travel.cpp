// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does the program stay within the travels of the machine?
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

std::optional<std::string> needs_travel(const Setup& setup) {
    const auto& travel = setup.machine.travel;
    if (std::ranges::none_of(travel, [](const auto& t) { return t.has_value(); })) {
        return "no travels are told (machine.toml, [travel])";
    }
    if (!setup.machine.work_zero) {
        return "where the work zero (G54) lies in the machine is not told; only the length of the "
               "way was compared with the travels";
    }
    return std::nullopt;
}

namespace {

constexpr double kRounding = 1e-9;  // 1 pm: what sums of decimal fractions leave

// A move in a system that nobody placed, or by increments from anywhere, ends where it is taken to.
// Stock and tool have no part in it.
std::vector<std::string_view> guesses_of_place(const Setup& setup, const Move& move) {
    std::vector<std::string_view> guesses = guesses_of(setup, move);
    std::erase_if(guesses, [](std::string_view reason) {
        return reason != "offset-guess" && reason != "start-unknown";
    });
    return guesses;
}

// Where the work zero is not known: a way longer than the travel fits nowhere.
void compare_ways(const Setup& setup, const Move& move, FindingLog& log) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto& travel = setup.machine.travel[static_cast<std::size_t>(axis)];
        if (!travel) continue;
        const double way = move.way.size()[axis];
        const double beyond = way - (travel->max - travel->min);
        if (beyond <= kRounding || way <= move.way_before.size()[axis]) continue;
        Sighting s{fmt::format("the way in {} is longer than the travel of {:.6g} mm", "XYZ"[axis],
                               travel -> max - travel -> min)};
        s.lasts = true;
        s.quantity = Quantity{"by", beyond, "mm"};
        s.box = move.path;
        s.rests_on = guesses_of_place(setup, move);
        log.add("over-travel", move, std::move(s));
    }
}

}  // namespace

void judge_over_travel(const Setup& setup, const Move& move, FindingLog& log) {
    if (!move.is_move || move.is_tilted_tip) return;
    if (!move.machine_path) {
        compare_ways(setup, move, log);
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto& travel = setup.machine.travel[static_cast<std::size_t>(axis)];
        if (!travel) continue;
        const double below = travel->min - move.machine_path->min[axis];
        const double above = move.machine_path->max[axis] - travel->max;
        if (below <= kRounding && above <= kRounding) continue;
        Sighting s{fmt::format("{} runs beyond its {} end at {:.6g}", "XYZ"[axis],
                               above > kRounding ? "upper" : "lower",
                               above > kRounding ? travel->max : travel->min)};
        s.quantity = Quantity{"by", std::max(below, above), "mm"};
        s.box = move.path;
        s.rests_on = guesses_of_place(setup, move);
        if (move.motion->machine_coordinates && !setup.home_assumption.empty()) {
            s.assumptions.push_back("home: " + setup.home_assumption);
        }
        if (axis == 2 && move.length_offset == 0.0) {
            s.assumptions.emplace_back("tool length: 0, no offset is active (G43)");
        }
        log.add("over-travel", move, std::move(s));
    }
}

}  // namespace ncsim::verify
