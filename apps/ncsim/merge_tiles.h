// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "merge_options.h"

#include <string>
#include <vector>

namespace ncsim::app {

/// Makes of tiles what one `ncsim run` of the same words makes; returns its exit code. Throws
/// std::runtime_error if one is missing, cut off or foreign, or if it is asked for what tiles do
/// not know.
int merge_tiles(const MergeOptions& options, std::vector<std::string> files);

}  // namespace ncsim::app
