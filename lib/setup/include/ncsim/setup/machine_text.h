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

/// TOML that read_machine_file() reads: links, travels, rates, offsets and control; fixtures and
/// limits of tools are not written.
std::string machine_toml(const MachineFile& file);

}  // namespace ncsim::setup
