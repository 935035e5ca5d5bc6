// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fixtures that pictures and pages show.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/machine_description.h"

#include <optional>
#include <vector>

namespace ncsim::app {

/// Returns the fixtures of the job and the machine, in W; may be empty. Prints the fixtures whose
/// place is unknown.
std::vector<verify::Fixture> placed_fixtures(const simulation::Plan& plan,
                                             const simulation::Survey& survey,
                                             const std::optional<setup::MachineFile>& machine);

}  // namespace ncsim::app
