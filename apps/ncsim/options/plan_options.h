// SPDX-License-Identifier: GPL-3.0-or-later
//
// From options to a plan.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/simulation/plan.h"

#include "options/run_options.h"

namespace ncsim::app {

/// Reads what the options name; throws what setup::read_job() throws.
simulation::Plan plan_for(const ProgramOptions& program, const SimulationOptions& simulation,
                          setup::InputSet& inputs);
simulation::Plan plan_for(const Options& options, setup::InputSet& inputs);

}  // namespace ncsim::app
