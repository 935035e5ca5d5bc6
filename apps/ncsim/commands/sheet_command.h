// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim sheet`: the set-up sheet of a job.
#pragma once

#include "options/program_options.h"

#include <string>

namespace ncsim::app {

struct SheetOptions : ProgramOptions {
    std::string html;  ///< Output file.
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, SheetOptions& options);
/// Checks `options` after all options were read.
/// Throws: Refusal.
void complete(SheetOptions& options);

/// Writes the sheet. Returns kFindings if a program has errors.
/// Throws: std::runtime_error on an environment failure.
int run(const SheetOptions& options);

}  // namespace ncsim::app
