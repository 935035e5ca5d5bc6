// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim run --tile`: one tile of a part, and its file, which `ncsim check --tile` has, too.
#pragma once

#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"
#include "ncsim/setup/input.h"
#include "ncsim/simulation/plan.h"

#include "options/run_options.h"
#include "system/output.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Cuts one tile; its result goes into a folder. Does nothing if it is there already. Returns the
/// exit code. Throws std::runtime_error as run() does.
int run_tile(Options options);

/// Cuts that of options.number, and says nothing but what is wrong with the program, if it may.
/// Nothing: it was not simulated. Throws std::runtime_error as run() does.
std::optional<report::TileFile> cut_tile(const Options& options, setup::InputSet& inputs,
                                         bool may_say);

/// Where the result of a tile goes.
class TilePlace {
public:
    /// `head` without its files; `folder` for the result.
    TilePlace(report::TileHead head, std::string folder);
    /// Is it there, made of files that are still what they were?
    bool is_done(setup::InputSet& inputs) const;
    /// Makes the folder, and sees to it that the file is no input.
    void reserve(OutputSet& outputs) const;
    void write(const report::TileFile& file, OutputSet& outputs) const;
    /// "tile 1 of 4 `what`: tiles/…". Returns kClean.
    int say(const char* what) const;

private:
    report::TileHead head_;
    std::string folder_, path_;
};

/// All tiles: `files[order[i]]` is tile i, of which `read(i)` reads TileFile::tile. Throws
/// std::runtime_error if they do not fit together.
std::shared_ptr<const simulation::CutTiles> tiles_in_order(
    const std::vector<report::TileFile>& files, const std::vector<std::size_t>& order,
    const cda::Tiles::Read& read, unsigned threads);

/// Throws std::runtime_error, naming it, if it is no result of that, or not whole.
report::TileFile read_tile(const std::string& path);

/// The part was made of these files, and of no others: throws std::runtime_error otherwise.
void expect_same_files(const report::FileDigests& then, const report::FileDigests& now);

}  // namespace ncsim::app
