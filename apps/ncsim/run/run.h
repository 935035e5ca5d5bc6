// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim run`: from options to files and an exit code.
#pragma once

#include "options/run_options.h"

namespace ncsim::app {

/// Runs the command and returns the exit code.
/// Throws: std::runtime_error on an environment failure; no output file was then made or changed.
int run(Options options);

}  // namespace ncsim::app
