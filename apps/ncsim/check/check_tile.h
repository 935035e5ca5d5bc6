// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim check --tile`: what one tile of a part meets, and its file.
#pragma once

#include "options/check_options.h"

namespace ncsim::app {

/// Asks one tile; its result goes into a folder. Does nothing if it is there already. Returns the
/// exit code, which tells of the machine alone. Throws std::runtime_error as run() does.
int check_tile(CheckOptions options);

}  // namespace ncsim::app
