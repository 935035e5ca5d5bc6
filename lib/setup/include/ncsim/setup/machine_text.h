// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine in words, and as a file that says the same.
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// For people: its joints from the part to the tool, travels, what the control does, what nobody
/// told.
std::string machine_sheet(const MachineFile& file);

/// What a machine.toml made of it would not say, in words: "2 fixtures, limits of tools"; empty:
/// nothing.
std::string not_in_machine_toml(const MachineFile& file);

/// TOML that read_machine_file() reads to the same, but for not_in_machine_toml(). What was assumed
/// stays so: the key `assumed` makes verdicts doubt it until somebody takes it out.
std::string machine_toml(const MachineFile& file);

}  // namespace ncsim::setup
