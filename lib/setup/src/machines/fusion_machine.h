// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines in the format of Fusion and HSMWorks (.machine, XML).
#pragma once

#include "ncsim/setup/machine_file.h"

#include <string>

namespace ncsim::setup {

/// Reads axes with ranges and rates, the spindle, the largest feed, and the time of a tool change.
/// A value of 0 counts as unspecified. The format specifies neither the positive direction of
/// rotary axes nor which of two carries the second. Assumed are right-handed rotations, of the part
/// on a table and of the tool on a head, and the order of the file from the bed on; both are
/// recorded as assumptions. Throws: std::runtime_error with file and line for a file of another
/// format.
MachineFile read_fusion_machine(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
