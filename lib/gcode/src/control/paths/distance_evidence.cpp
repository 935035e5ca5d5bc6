// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of axis words before any G90 or G91.
#include "control/paths/distance_evidence.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {

void DistanceEvidence::take(const Command& command, const MachineState& state,
                            const ProgramPlace& place) {
    constexpr std::array kLetters{'X', 'Y', 'Z'};
    const bool names_axis = command.has_any(letters('X', 'Y', 'Z'));
    if (!names_axis || command.group(Group::OneShot) == Code::G53) return;
    if (!first) first = place;
    if (is_cycle(state.motion)) return;
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

bool DistanceEvidence::are_places() const {
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
