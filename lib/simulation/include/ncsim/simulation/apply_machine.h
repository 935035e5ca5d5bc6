// SPDX-License-Identifier: GPL-3.0-or-later
//
// Application of a machine file to a plan.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"

#include <string>
#include <vector>

namespace ncsim::simulation {

/// Sets kinematics, functions of the control and reference points of `plan` from `file`, and
/// offsets and start unless the job specifies them. Returns the values that cannot be used, in
/// words.
std::vector<std::string> apply_machine(Plan& plan, const setup::MachineFile& file);

}  // namespace ncsim::simulation
