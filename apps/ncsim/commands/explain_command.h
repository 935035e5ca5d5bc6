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
    bool no_volume = false;  ///< Leaves out the removed volume, without a simulation.
    bool json = false;
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, ExplainOptions& options);
/// Checks `options` after all options were read; "part.nc:120" as the program names a line.
/// Throws: Refusal.
void complete(ExplainOptions& options);

/// Prints the block to the standard output. Returns kFindings if the block has errors, or is not
/// reached.
/// Throws: std::runtime_error on an environment failure.
int run(const ExplainOptions& options);

}  // namespace ncsim::app
