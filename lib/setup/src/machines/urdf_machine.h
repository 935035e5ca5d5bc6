// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine as URDF tells it, the format in which CAD programs export robots with their meshes.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Links with boxes and meshes (those of `collision`, else of `visual`), joints, limits, rates;
/// metres and radians. A joint that moves is an axis, by its name: X, Y, Z, A, B or C, alone or
/// behind or before a word (`joint_a`, `C-axis`). The link `workpiece` carries the part, and the
/// frame of the link `tool` is the spindle nose, z into the spindle, with all joints at 0. A table
/// that goes along an axis by positive values counts the other way than machine tools do: it is
/// taken to count as they do, and told as a guess.
///
/// Throws std::runtime_error, naming file and line, for what is no such file.
MachineFile read_urdf_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
