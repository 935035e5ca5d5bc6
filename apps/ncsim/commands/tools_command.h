// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim tools`: the tool sheet of a program.
#pragma once

#include "options/program_options.h"

#include <string>

namespace ncsim::app {

struct ToolsOptions : ProgramOptions {
    bool json = false;
    bool quiet = false;   ///< No sheet; only with a file to write.
    std::string convert;  ///< Job file or table of LinuxCNC to write, instead of a sheet.
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, ToolsOptions& options);

/// Throws: Refusal if a program is missing, or specified with `convert`.
void complete(ToolsOptions& options);

/// Prints the sheet to the standard output: each tool that is called or described, with shape,
/// source of the description and work. Prints findings to stderr.
/// Throws: std::runtime_error on an environment failure.
int run(const ToolsOptions& options);

}  // namespace ncsim::app
