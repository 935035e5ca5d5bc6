// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merge of tiles of `ncsim check --tile` into a verdict.
#pragma once

#include "ncsim/report/tile_file.h"

#include "commands/options.h"
#include "options/merge_options.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Parses the words of tiles.
/// Throws: std::runtime_error if they are no command.
Command command_of_tiles(const std::vector<std::string>& words);

/// Reports the verdict from the observations of all tiles. `files[order[i]]` is tile i;
/// TileFile::tile may be absent there, and `read(i)` returns the text. `has_part`: a tile has a
/// part. Returns the exit code.
/// Throws: std::runtime_error as run() does.
int merge_checks(const MergeOptions& merge, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, bool has_part,
                 const std::function<std::string(std::size_t)>& read);

}  // namespace ncsim::app
