// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides from the values whether the axis words before any G90 or G91 are positions or increments.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// Statistics of the moves before G90 and G91.
struct DistanceEvidence {
    std::optional<ProgramPlace> first;  ///< First of the moves.
    bool is_certain = false;            ///< G91 follows, so G90 was in force.
    /// Sums and largest absolute values of X, Y, Z; program units.
    std::array<double, 3> sum{}, largest{};
    std::uint64_t moves = 0;
    std::uint64_t rests = 0;  ///< Moves without effect if the values are positions.
    /// Arcs whose end lies on the circle only if the values are positions, or only if increments.
    std::uint64_t arcs_of_places = 0, arcs_of_steps = 0;

    /// Records a move that starts at `state`.
    void take(const Command& command, const MachineState& state, const ProgramPlace& place);
    /// True if the values are positions: only then the ends of arcs lie on the circles, or as
    /// increments the values would lead far away from the start.
    bool are_places() const;

private:
    void take_arc(const Command& command, const MachineState& state);
};

}  // namespace ncsim::gcode
