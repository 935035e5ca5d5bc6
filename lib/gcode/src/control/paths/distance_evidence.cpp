// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of axis words before any G90 or G91.
#include "control/paths/distance_evidence.h"

#include "ncsim/base/angles.h"

#include "control/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode {

void DistanceEvidence::take(const Command& command, const MachineState& state,
                            const ProgramPlace& place) {
    constexpr std::array kLetters{'X', 'Y', 'Z'};
    const bool names_axis = command.has_any(letters('X', 'Y', 'Z'));
    if (!names_axis || command.group(Group::OneShot) == Code::G53) return;
    if (!first) first = place;
    if (is_cycle(state.motion)) return;
    if (state.motion == Code::G2 || state.motion == Code::G3) take_arc(command, state);
    ++moves;
    bool rest = true;
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
        if (!command.has(kLetters[i])) continue;
        const double value = command[kLetters[i]];
        rest &= value == state.position[i];
        sum[i] += value;
        largest[i] = std::max(largest[i], std::abs(value));
    }
    if (rest) ++rests;
}

void DistanceEvidence::take_arc(const Command& command, const MachineState& state) {
    const PlaneAxes axes = axes_of(state.plane);
    if (state.absolute_centres || state.frames.programmed.changes_places()) return;
    const std::array in_plane{axes.first, axes.second};
    std::array<double, 2> place{}, step{}, centre{};  // relative to the start of the arc
    for (std::size_t i = 0; i < in_plane.size(); ++i) {
        const std::size_t axis = in_plane[i];
        if (axis > kZ) return;  // of U, V, W
        if (command.has("XYZ"[axis])) {
            step[i] = command["XYZ"[axis]];
            place[i] = step[i] - state.position[axis];
        }
        centre[i] = command.get("IJK"[axis], 0.0);
    }
    const double radius = hypotenuse(centre[0], centre[1]);
    const bool by_radius = command.has('R') && radius == 0.0;
    // By how much of its radius the end is off the circle, or the chord longer than the diameter.
    const auto misfit = [&](const std::array<double, 2>& end) {
        if (by_radius) return hypotenuse(end[0], end[1]) / (2.0 * std::abs(command['R'])) - 1.0;
        return std::abs(hypotenuse(end[0] - centre[0], end[1] - centre[1]) / radius - 1.0);
    };
    constexpr double kFits = 0.002, kMisses = 0.05;
    const double of_place = misfit(place), of_step = misfit(step);
    if (of_place < kFits && of_step > kMisses) ++arcs_of_places;
    if (of_step < kFits && of_place > kMisses) ++arcs_of_steps;
}

bool DistanceEvidence::are_places() const {
    if (arcs_of_steps > 0) return false;
    if (arcs_of_places > 0) return true;
    // A closed contour of increments ends at the start, so sums stay small. Increments in a
    // constant direction are repeated values, which are rests if read as positions.
    constexpr double kFar = 4.0;
    constexpr std::uint64_t kMostRests = 10;  // At most 1 rest in kMostRests moves.
    if (rests * kMostRests > moves) return false;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (std::abs(sum[i]) > kFar * largest[i]) return true;
    }
    return false;
}

}  // namespace ncsim::gcode
