// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim merge`.
#pragma once

#include "options/merge_options.h"

namespace ncsim::app {

/// Reports and writes the result that a single `ncsim check` of the whole list would have, or for
/// tiles a single `ncsim run`. Returns its exit code.
/// Throws: std::runtime_error if a shard or a tile is missing, truncated or foreign, or an output
///   cannot be written.
int run(MergeOptions options);

}  // namespace ncsim::app
