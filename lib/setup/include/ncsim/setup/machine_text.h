// SPDX-License-Identifier: GPL-3.0-or-later
//
// Description of a machine in words, and as machine.toml.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Returns a description in words: joints from the part to the tool, travels, functions of the
/// control, and assumptions.
std::string machine_sheet(const MachineFile& file);

/// Returns the values of `file` that machine_toml() does not write, in words: "2 fixtures, limits
/// of tools"; empty if there are none.
std::string not_in_machine_toml(const MachineFile& file);

/// Returns TOML from which read_machine() reads the same machine, except for
/// not_in_machine_toml(). Assumptions are kept: the key `assumed` causes a doubt until it is
/// removed.
std::string machine_toml(const MachineFile& file);

}  // namespace ncsim::setup
