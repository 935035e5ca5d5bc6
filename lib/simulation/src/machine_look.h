// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine on the page of a program.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include <optional>

namespace ncsim::simulation {

/// Links that have a mesh, the tools, and where joints stand after each line. Nothing where no link
/// has one, or nobody tells how the machine turns, or from where it moves.
std::optional<report::MachineLook> machine_look(const Plan& plan, const Survey& survey,
                                                const setup::MachineFile& machine);

}  // namespace ncsim::simulation
