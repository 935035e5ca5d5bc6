// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merge of tiles of `ncsim run --tile`.
#pragma once

#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"

#include "options/merge_options.h"
#include "options/run_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::app {

/// Makes the same outputs from tiles as a single `ncsim run` of the same words; returns its exit
/// code.
/// Throws: std::runtime_error if a tile is missing, truncated or foreign, or if an output cannot be
///   made from tiles.
int merge_tiles(const MergeOptions& options, std::vector<std::string> files);

/// Makes the outputs that `options` request from all tiles. Tile i is files[order[i]];
/// TileFile::tile may be absent there, and `read` returns the text. Returns the exit code.
/// Throws: std::runtime_error as merge_tiles() does.
int run_of_tiles(Options options, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, const cda::Tiles::Read& read);

}  // namespace ncsim::app
