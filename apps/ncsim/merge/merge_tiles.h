// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"

#include "options/merge_options.h"
#include "options/run_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::app {

/// Makes of tiles what one `ncsim run` of the same words makes; returns its exit code. Throws
/// std::runtime_error if one is missing, cut off or foreign, or if it is asked for what tiles do
/// not know.
int merge_tiles(const MergeOptions& options, std::vector<std::string> files);

/// What `options` ask for, of all tiles: tile i is files[order[i]], of which `read` knows
/// TileFile::tile, which may be gone there. Returns the exit code; throws std::runtime_error as
/// merge_tiles() does.
int run_of_tiles(Options options, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, const cda::Tiles::Read& read);

}  // namespace ncsim::app
