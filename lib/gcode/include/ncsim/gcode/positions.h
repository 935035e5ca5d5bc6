// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions in the coordinates of a control: as programmed, in the active system, in the machine.
// Lengths are in active units, angles in degrees.
#pragma once

#include "ncsim/gcode/state.h"

namespace ncsim::gcode {

/// Removes G68 and G51 from a position in the active system.
Axes to_programmed(const ProgrammedTransform& transform, const Axes& position);
/// Applies G51, then G68, to a programmed position.
Axes from_programmed(const ProgrammedTransform& transform, const Axes& programmed);

/// Returns `state.position` in machine coordinates, of X, Y and Z along axes with frame 0 only.
/// Source: the formula of state.h.
Axes machine_position(const MachineState& state);
/// Transforms a position in machine coordinates to the active system.
Axes from_machine(const MachineState& state, const Axes& machine);

}  // namespace ncsim::gcode
