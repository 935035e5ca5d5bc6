// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in URDF, a format in which CAD programs export robots with their meshes.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Reads links with boxes and meshes (from `collision`, otherwise from `visual`), joints, limits
/// and rates, in metres and radians. A joint that moves is an axis, by its name: X, Y, Z, A, B or
/// C, alone or at either end of a name (`joint_a`, `C-axis`). The link `workpiece` carries the
/// part. The frame of the link `tool` is the spindle nose, z into the spindle, with all joints at
/// 0. A table that moves along an axis by positive values counts contrary to machine tools: it is
/// assumed to count as machine tools do, and this is recorded as an assumption.
///
/// Throws: std::runtime_error with file and line for a file of another format.
MachineFile read_urdf_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
