// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine as the CAM workbench of FreeCAD keeps it (.fcm, JSON).
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Axes with their roles, parents, joints, limits and rates; the spindle. Which way tables count is
/// not written there: taken to be the right hand about the axis, and told as a guess; places of
/// axes that are [0, 0, 0], which is what FreeCAD writes where nobody tells, are not told. Throws
/// std::runtime_error, naming the file, the line and the key, for what is no such file.
MachineFile read_freecad_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
