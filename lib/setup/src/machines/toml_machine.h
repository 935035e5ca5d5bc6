// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files in TOML.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Reads and checks the file `path`. Throws: std::runtime_error with file, line and column, for a
/// file that is not TOML, unknown keys, wrong types and invalid values.
MachineFile read_toml_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
