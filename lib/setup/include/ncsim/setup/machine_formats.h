// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in whatever format somebody told them.
#pragma once

#include "ncsim/setup/machine_file.h"

namespace ncsim::setup {

/// A configuration of LinuxCNC where the name ends in ".ini", a machine of FreeCAD where it ends in
/// ".fcm", one of Fusion where it ends in ".machine", one in URDF where in ".urdf", else the
/// project's own TOML. Throws std::runtime_error as their readers do.
MachineFile read_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
