// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the program's zero is on the machine that turns.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/simulation/plan.h"

#include <array>
#include <optional>
#include <string>

namespace ncsim::simulation {

/// Where the program's zero, W, lies in the machine, mm; nothing if nobody tells.
std::optional<cda::Vec3> work_zero(const gcode::WorkOffset& workpiece);

/// plan.placed from plan.kinematics and what the program says of its zero. Axes of which nobody
/// told where they lie are taken to pass through it.
void place_kinematics(Plan& plan);

/// Which axes stand elsewhere than at 0 in some move of a program.
struct AxesInUse {
    std::array<bool, 3> turns{};  ///< A, B, C.
    /// U, V and W: with X, Y and Z as places of the axes, and of the tip.
    std::array<bool, 3> uvw{}, uvw_of_tip{};
};

/// What of the way they go nobody told, in words, empty: nothing. `of_tip`: where the program tells
/// places of the tip; then only directions count.
std::string kinematics_guess(const Plan& plan, const gcode::WorkOffset& workpiece,
                             const AxesInUse& axes, bool of_tip);

}  // namespace ncsim::simulation
