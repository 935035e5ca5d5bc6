// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adapter of a chain of joints to the interpreter's JointSolver.
#pragma once

#include "ncsim/gcode/joints.h"
#include "ncsim/machine/orient.h"
#include "ncsim/toolpath/kinematics.h"

#include <memory>

namespace ncsim::simulation {

/// Returns the solver. `workpiece` is the position of W in the interpreter's coordinates;
/// `placed.zero` is the same position in the chain's coordinates.
std::shared_ptr<const gcode::JointSolver> make_joint_solver(const toolpath::Kinematics& placed,
                                                            const gcode::WorkOffset& workpiece,
                                                            const machine::Travels& travels,
                                                            machine::SolutionPreference prefer);

}  // namespace ncsim::simulation
