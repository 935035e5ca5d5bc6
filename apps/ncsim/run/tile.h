// SPDX-License-Identifier: GPL-3.0-or-later
//
// `ncsim run --tile`: one tile of a part, and its file, which `ncsim check --tile` shares.
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

/// Cuts a tile and writes the result to a folder, unless the result exists. Returns the exit code.
/// Throws: std::runtime_error as run() does.
int run_tile(Options options);

/// Cuts the tile of options.number. If `may_say`, reports faults of the program. Empty if the
/// program was not simulated.
/// Throws: std::runtime_error as run() does.
std::optional<report::TileFile> cut_tile(const Options& options, setup::InputSet& inputs,
                                         bool may_say);

/// File for the result of a tile.
class TilePlace {
public:
    /// Creates the place for `head` (without files) in `folder`.
    TilePlace(report::TileHead head, std::string folder);
    /// True if the result exists and the input files are unchanged.
    bool is_done(setup::InputSet& inputs) const;
    /// Creates the folder, and ensures that the file is no input.
    void reserve(OutputSet& outputs) const;
    void write(const report::TileFile& file, OutputSet& outputs) const;
    /// Reports "tile 1 of 4 `what`: tiles/…". Returns kClean.
    int report_done(const char* what) const;

private:
    report::TileHead head_;
    std::string folder_, path_;
};

/// Combines all tiles. `files[order[i]]` is tile i; `read(i)` returns TileFile::tile.
/// Throws: std::runtime_error if the tiles do not fit together.
std::shared_ptr<const simulation::CutTiles> tiles_in_order(
    const std::vector<report::TileFile>& files, const std::vector<std::size_t>& order,
    const cda::Tiles::Read& read, unsigned threads);

/// Reads the file of a tile.
/// Throws: std::runtime_error with the path if the file is no tile or is incomplete.
report::TileFile read_tile(const std::string& path);

/// Checks that the same input files are read now as when the part was made.
/// Throws: std::runtime_error if the files differ.
void expect_same_files(const report::FileDigests& then, const report::FileDigests& now);

}  // namespace ncsim::app
