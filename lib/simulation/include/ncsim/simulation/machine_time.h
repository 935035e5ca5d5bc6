// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machining times on a given machine.
#pragma once

#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/ledger.h"
#include "ncsim/verify/machine_description.h"

namespace ncsim::simulation {

/// Sums the times that `check` gives for the program on this machine: feed, rapid, the rest. Times
/// that depend on an unknown rate of the machine are empty. Rows of blocks are empty.
/// Cost: one pass over the motions of the program.
verify::Ledger machining_times(const Plan& plan, const Survey& survey,
                               const verify::MachineDescription& machine);

}  // namespace ncsim::simulation
