// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim tools`: the tool sheet of a program.
#pragma once

#include "options/program_options.h"

namespace ncsim::app {

struct ToolsOptions : ProgramOptions {
    bool json = false;
};

/// The command `tools` of `app`. It reads into `options`, which must outlive it.
cli::App* add_tools(cli::App& app, ToolsOptions& options);

/// The sheet to the standard output: each tool that is called or described, its shape, who said so,
/// what it does. Findings to stderr. Throws std::runtime_error if the world fails.
int run(const ToolsOptions& options);

}  // namespace ncsim::app
