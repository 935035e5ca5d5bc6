// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim init`: a first job file for programs, or a first ncsim.toml for a folder.
#pragma once

#include "options/program_options.h"

#include <string>
#include <vector>

namespace ncsim::app {

struct InitOptions {
    std::vector<std::string> programs;  ///< NC programs, a set-up each; with `repo` a folder.
    std::string output;                 ///< File to write; empty: job.toml or ncsim.toml.
    bool repo = false;                  ///< Write ncsim.toml.
    bool quiet = false;                 ///< Print errors and warnings only.
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, InitOptions& options);
/// Checks `options` after all options were read.
/// Throws: Refusal.
void complete(InitOptions& options);

/// Writes the file. Never replaces an existing file.
/// Throws: std::runtime_error if the file exists, or on an environment failure; then no file is
/// left.
int run(const InitOptions& options);

}  // namespace ncsim::app
