// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files in all supported formats.
#pragma once

#include "ncsim/setup/machine_file.h"

namespace ncsim::setup {

/// Reads a machine. The end of the name decides the format: ".ini" LinuxCNC, ".fcm" FreeCAD,
/// ".machine" Fusion, ".urdf" URDF, otherwise a machine.toml. Throws: std::runtime_error, as the
/// readers of these formats do.
MachineFile read_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
