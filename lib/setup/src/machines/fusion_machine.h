// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine as Fusion and HSMWorks keep it (.machine, XML).
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Axes with ranges and rates, the spindle, the largest feed, the time of a tool change. What is 0
/// there is not told. Of rotary axes it does not tell which way they count, nor which of two
/// carries the other: taken to be the right hand, of the part on a table and of the tool on a head,
/// and the order of the file from the bed on; told as a guess. Throws std::runtime_error, naming
/// file and line, for what is no such file.
MachineFile read_fusion_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
