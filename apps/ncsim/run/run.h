// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim run`: from options to files and an exit code.
#pragma once

#include "options/run_options.h"

namespace ncsim::app {

/// Throws std::runtime_error if the world fails; then no output file was made or changed.
int run(Options options);

}  // namespace ncsim::app
