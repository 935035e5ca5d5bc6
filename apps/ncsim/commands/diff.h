// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim diff`, which compares the parts of two programs or jobs, for example after a
// change of a post-processor.
#pragma once

#include "options/program_options.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::app {

/// Options of `ncsim diff`; `program` is the old program, or `job` the old job.
struct DiffOptions : ProgramOptions, SimulationOptions {
    std::string new_program;     ///< New program or job file.
    double tolerance_mm3 = 0.0;  ///< Differences up to this volume do not count.
    bool process = false;        ///< Exit code 1 also for different feeds and speeds.
    std::string json;            ///< Output file; empty: none.
    std::string html;            ///< The same, for the review.
    bool quiet = false;
    std::vector<std::string> words;  ///< Options of the command line, without OLD and NEW.
    /// Options of the new job; null if it is the old job, or no job.
    std::shared_ptr<const DiffOptions> of_new_job;
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, DiffOptions& options);
void complete(DiffOptions& options);

/// Compares two programs, or the programs of two jobs in each set-up. Returns 0 if the parts (and
/// with `process`, the processes) are equal; 1 if they differ; 2 if a program cannot be cut.
/// Throws: std::runtime_error on an environment failure.
int run(const DiffOptions& options);

}  // namespace ncsim::app
