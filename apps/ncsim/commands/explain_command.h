// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim explain`: the state of the control at a block, and what the block does.
#pragma once

#include "options/program_options.h"

#include <cstdint>
#include <string>

namespace ncsim::app {

struct ExplainOptions : ProgramOptions, SimulationOptions {
    std::uint32_t line = 0;  ///< From 1.
    std::string in;          ///< Called file that has the line; empty: the program.
    std::string machine;     ///< Machine file.
    bool no_volume = false;  ///< Leaves out the removed volume, without a simulation.
    bool json = false;
};

/// Adds the command `explain` to `app`, which reads into `options`.
/// Requires: `options` outlives `app`.
cli::App* add_explain(cli::App& app, ExplainOptions& options);
/// Checks `options` after all options were read; "part.nc:120" as the program names a line.
/// Throws: Refusal.
void complete(ExplainOptions& options);

/// Prints the block to the standard output. Returns kFindings if the block has errors, or is not
/// reached.
/// Throws: std::runtime_error on an environment failure.
int run(const ExplainOptions& options);

}  // namespace ncsim::app
