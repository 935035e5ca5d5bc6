// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meaning of a program's X, Y and Z, estimated from its moves. A hole is drilled, and a cut begun,
// along the tool. So moves along an inclined tool show whether X, Y and Z are positions of the tip,
// and on which machine; moves along Z alone show that they are positions of axes.
#pragma once

#include "ncsim/report/tool_sheet.h"
#include "ncsim/simulation/plan.h"

namespace ncsim::simulation {

/// Least length of a straight move, mm, and largest angle to a direction, degrees.
inline constexpr double kLeastPlunge = 3.0, kPlungeDegrees = 0.4;

/// Counts plunges for all presets, for each preset with inverted rotary axes, and for the machine
/// of `plan`. Without a machine, M428 to M430 and G43.4 do not change coordinates. Cost: one
/// interpretation of the program.
report::Plunges plunges_of(const Plan& plan);

}  // namespace ncsim::simulation
