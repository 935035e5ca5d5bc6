// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim check --tile`: observations of a tile of a part, and the file of the tile.
#pragma once

#include "options/check_options.h"

namespace ncsim::app {

/// Observes a tile and writes the result to a folder, unless the result exists. Returns the exit
/// code, which reports environment failures only.
/// Throws: std::runtime_error as run() does.
int check_tile(CheckOptions options);

}  // namespace ncsim::app
