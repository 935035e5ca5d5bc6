// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a machine file tells of how a program runs on that machine.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"

#include <string>
#include <vector>

namespace ncsim::simulation {

/// Offsets, reference points, the start and how the machine turns go into `plan`, where its job
/// does not tell them. Returns what cannot be used, in words.
std::vector<std::string> take_machine(Plan& plan, const setup::MachineFile& file);

}  // namespace ncsim::simulation
