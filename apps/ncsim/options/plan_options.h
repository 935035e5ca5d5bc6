// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of options into a plan.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/simulation/plan.h"

#include "options/run_options.h"

#include <stop_token>

namespace ncsim::app {

/// Reads the files that the options name and returns the plan, as simulation::read_plan().
simulation::Plan plan_for(const ProgramOptions& program, const SimulationOptions& simulation,
                          setup::InputSet& inputs, const std::stop_token& stop = {});
simulation::Plan plan_for(const Options& options, setup::InputSet& inputs);

}  // namespace ncsim::app
