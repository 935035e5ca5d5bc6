// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of options into a plan.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"

#include "options/run_options.h"

#include <optional>
#include <stop_token>
#include <string>

namespace ncsim::app {

/// Reads the files that the options name and returns the plan. For a later step of a job with
/// set-ups, the earlier steps are cut first, on `machine` (a file; empty: none); their part is the
/// stock. `stop` ends their simulation.
/// Throws: as setup::read_job(); std::runtime_error if an earlier step leaves no part.
simulation::Plan plan_for(const ProgramOptions& program, const SimulationOptions& simulation,
                          const std::string& machine, setup::InputSet& inputs,
                          const std::stop_token& stop = {});
simulation::Plan plan_for(const Options& options, setup::InputSet& inputs);

/// Reads the machine file `path` (empty: none) and adds the fixtures of `job`. Empty if there are
/// neither.
std::optional<setup::MachineFile> machine_for(const std::string& path, const setup::Job& job,
                                              setup::InputSet& inputs);
/// Adds the fixtures and the free space below the stock of `job` to `machine`. Returns false if the
/// job specifies no fixtures.
bool add_fixtures(setup::MachineFile& machine, const setup::Job& job);

}  // namespace ncsim::app
