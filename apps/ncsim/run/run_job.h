// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of all set-ups of a job.
#pragma once

#include "options/job_steps.h"
#include "options/run_options.h"

#include <functional>
#include <vector>

namespace ncsim::app {

/// Runs the steps of a job one after another by `run_step`. Outputs of the command line, and
/// outputs at the top of the job file, belong to the last step; each set-up may have outputs of its
/// own. Returns the worst exit code. Throws: std::runtime_error on an environment failure; outputs
/// of earlier steps are then written.
int run_job(const Options& options, const std::vector<ChosenStep>& steps,
            const std::function<int(Options)>& run_step);

}  // namespace ncsim::app
