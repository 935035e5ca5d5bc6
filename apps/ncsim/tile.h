// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim run --tile`: one tile of a part, and its file.
#pragma once

#include "ncsim/report/tile_file.h"
#include "ncsim/setup/input.h"

#include "run_options.h"

#include <optional>
#include <string>

namespace ncsim::app {

/// Cuts one tile; its result goes into a folder. Does nothing if it is there already. Returns the
/// exit code. Throws std::runtime_error as run() does.
int run_tile(Options options);

/// Cuts that of options.number, and says nothing but what is wrong with the program, if it may.
/// Nothing: it was not simulated. Throws std::runtime_error as run() does.
std::optional<report::TileFile> cut_tile(const Options& options, setup::InputSet& inputs,
                                         bool may_say);

/// Throws std::runtime_error, naming it, if it is no result of that, or not whole.
report::TileFile read_tile(const std::string& path);

/// The part was made of these files, and of no others: throws std::runtime_error otherwise.
void expect_same_files(const report::FileDigests& then, const report::FileDigests& now);

}  // namespace ncsim::app
