// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of the program zero on a specified machine.
#pragma once

#include "ncsim/gcode/interpreter.h"
#include "ncsim/simulation/plan.h"

#include <array>
#include <optional>
#include <string>

namespace ncsim::simulation {

/// Returns the program zero W in machine coordinates, mm; empty if unknown.
std::optional<Vec3> work_zero(const gcode::WorkOffset& workpiece);

/// Sets plan.placed from plan.kinematics and the program zero. Rotary axes of unknown position are
/// assumed to pass through the program zero.
void place_kinematics(Plan& plan);

/// Axes that are not at 0 in some move of a program.
struct AxesInUse {
    std::array<bool, 3> turns{};  ///< A, B, C.
    /// U, V and W, without and with tip control.
    std::array<bool, 3> uvw{}, uvw_of_tip{};
};

/// Returns the assumptions about the motion of these axes, in words; empty if none. `of_tip` is
/// true if the program gives positions of the tip; then only directions count.
std::string kinematics_guess(const Plan& plan, const gcode::WorkOffset& workpiece,
                             const AxesInUse& axes, bool of_tip);

}  // namespace ncsim::simulation
