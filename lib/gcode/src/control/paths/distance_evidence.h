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

    /// Takes a move to be made from `state`.
    void take(const Command& command, const MachineState& state, const ProgramPlace& place);
    /// True if the values are places: as steps they would lead far away from where the program
    /// began.
    bool are_places() const;
};

}  // namespace ncsim::gcode
