// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine as a configuration of LinuxCNC tells it: its INI file, and what that and the HAL files
// beside it set.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Kinematics by an allow-list (xyzac-trt-kins, xyzbc-trt-kins, xyzab_tdr_kins, 5axiskins,
/// xyzacb_trsrn; of trivkins nothing is known of how the machine turns), with the places of its
/// axes from HAL (setp, net, sets); limits, rates and accelerations; REMAPs of M codes that choose
/// kinematics. Throws std::runtime_error, naming file and line, for values that are none, other
/// kinematics, and files that are not there.
MachineFile read_linuxcnc_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
