// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim merge`.
#pragma once

#include "options/merge_options.h"

namespace ncsim::app {

/// Tells and writes what one `ncsim check` of the whole list would, or, of tiles, one `ncsim run`.
/// Returns its exit code. Throws std::runtime_error if a shard or a tile is missing, cut off or
/// foreign, or an output cannot be written.
int run(MergeOptions options);

}  // namespace ncsim::app
