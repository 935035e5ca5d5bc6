// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim merge` of what `ncsim check --tile` has written: a verdict.
#pragma once

#include "ncsim/report/tile_file.h"

#include "options/merge_options.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Tells the verdict of what all tiles met: `files[order[i]]` is tile i, of which `read(i)` reads
/// TileFile::tile, which may be gone there; `has_part`: there is any. Returns the exit code. Throws
/// std::runtime_error as run() does.
int merge_checks(const MergeOptions& merge, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, bool has_part,
                 const std::function<std::string(std::size_t)>& read);

}  // namespace ncsim::app
