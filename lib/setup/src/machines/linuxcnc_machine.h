// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in the format of LinuxCNC: an INI file, with the values that this file and its HAL files
// set.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Reads kinematics by an allow-list (xyzac-trt-kins, xyzbc-trt-kins, xyzab_tdr_kins, 5axiskins,
/// xyzacb_trsrn; trivkins leaves the kinematics unknown), with the positions of the axes from HAL
/// (setp, net, sets); limits, rates and accelerations; REMAPs of M codes that choose kinematics.
/// Throws: std::runtime_error with file and line, for invalid values, unknown kinematics, and
/// missing files.
MachineFile read_linuxcnc_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
