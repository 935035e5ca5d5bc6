// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the axis words before any G90 or G91 are places or steps, concluded from their values.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::gcode {

struct DistanceEvidence {
    std::optional<ProgramPlace> first;       ///< Of the moves.
    bool is_certain = false;                 ///< G91 follows, so G90 was in force before.
    std::array<double, 3> sum{}, largest{};  ///< Of the values of X, Y, Z; program units.
    std::uint64_t moves = 0;
    std::uint64_t rests = 0;  ///< Moves that lead nowhere if their values are places.
    /// Arcs whose end lies on their circle only if their values are places, or only if steps.
    std::uint64_t arcs_of_places = 0, arcs_of_steps = 0;

    /// Takes a move to be made from `state`.
    void take(const Command& command, const MachineState& state, const ProgramPlace& place);
    /// True if the values are places: the arcs fit as such alone, or as steps the values would lead
    /// far away from where the program began.
    bool are_places() const;

private:
    void take_arc(const Command& command, const MachineState& state);
};

}  // namespace ncsim::gcode
