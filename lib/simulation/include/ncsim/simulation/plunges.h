// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the moves of a program tell of what its X, Y and Z are: a hole is drilled, and a cut begun,
// along the tool. So where rotary axes hold the tool tilted, moves along it show whether they are
// places of the tip, and on which machine; moves along Z alone, that they are places of axes.
#pragma once

#include "ncsim/report/tool_sheet.h"
#include "ncsim/simulation/plan.h"

namespace ncsim::simulation {

/// Straight moves of no less than this, mm, along a direction within so many degrees.
inline constexpr double kLeastPlunge = 3.0, kPlungeDegrees = 0.4;

/// Of all presets, of each with its rotary axes counting the other way, and of the machine of
/// `plan`. Where none is told, M428 to M430 and G43.4 change nothing of the numbers. Reads the
/// program once.
report::Plunges plunges_of(const Plan& plan);

}  // namespace ncsim::simulation
