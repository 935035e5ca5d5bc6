// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in the format of FreeCAD's CAM workbench (.fcm, JSON).
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Reads axes with their roles, parents, joints, limits and rates, and the spindle. The format does
/// not specify the positive direction of tables: it is assumed to be right-handed about the axis,
/// and recorded as an assumption. A position [0, 0, 0] of an axis counts as unspecified, because
/// FreeCAD writes it as default. Throws: std::runtime_error with file, line and key for a file of
/// another format.
MachineFile read_freecad_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
