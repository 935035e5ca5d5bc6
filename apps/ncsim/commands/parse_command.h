// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim parse`: prints the interpretation of a program, as comparable text or as JSON.
#pragma once

#include "ncsim/gcode/control_codes.h"

#include "options/program_options.h"

namespace ncsim::app {

struct ParseOptions : ProgramOptions {
    bool canonical = false;  ///< Print the motions of the program instead of its blocks.
    bool json = false;
    /// List the codes that the control does not have.
    const gcode::ControlCodes* control = nullptr;
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, ParseOptions& options);

/// Prints the blocks or motions to the standard output, and messages to stderr.
/// Throws: std::runtime_error on an environment failure.
int run(const ParseOptions& options);

}  // namespace ncsim::app
