// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chain of joints as the interpreter asks it.
#pragma once

#include "ncsim/gcode/joints.h"
#include "ncsim/machine/orient.h"
#include "ncsim/toolpath/machine.h"

#include <memory>

namespace ncsim::simulation {

/// `workpiece`: where W is, in the coordinates that the interpreter counts in; `placed.zero` is the
/// same place as the chain has it.
std::shared_ptr<const gcode::JointSolver> make_joint_solver(const toolpath::Kinematics& placed,
                                                            const gcode::WorkOffset& workpiece,
                                                            const machine::Travels& travels,
                                                            machine::Prefer prefer);

}  // namespace ncsim::simulation
