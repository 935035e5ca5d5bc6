// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim measure`: dimensions that a calliper would find on the part.
#pragma once

#include "options/program_options.h"

#include <string>

namespace ncsim::app {

struct MeasureOptions : ProgramOptions, SimulationOptions {
    std::string json;  ///< Output file; empty: none.
    bool quiet = false;
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, MeasureOptions& options);
/// Checks `options` after all options were read.
/// Throws: Refusal.
void complete(MeasureOptions& options);

/// Prints the sheet to the standard output and findings to stderr. Returns kFindings, without a
/// sheet, if the program cannot be simulated.
/// Throws: std::runtime_error on an environment failure.
int run(const MeasureOptions& options);

}  // namespace ncsim::app
