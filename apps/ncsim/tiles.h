// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts in tiles: `ncsim run --tile`, and what `ncsim merge` makes of the results.
#pragma once

#include "ncsim/report/tile_file.h"

#include "merge.h"
#include "run_options.h"

#include <string>
#include <vector>

namespace ncsim::app {

/// Cuts one tile; its result goes into a folder. Does nothing if it is there already. Returns the
/// exit code. Throws std::runtime_error as run() does.
int run_tile(Options options);

/// Makes of tiles what one `ncsim run` of the same words makes. Throws std::runtime_error if one is
/// missing, cut off or foreign, or if it is asked for what tiles do not know.
int merge_tiles(const MergeOptions& options, std::vector<std::string> files);

/// The part was made of these files, and of no others: throws std::runtime_error otherwise.
void expect_same_files(const report::FileDigests& then, const report::FileDigests& now);

}  // namespace ncsim::app
