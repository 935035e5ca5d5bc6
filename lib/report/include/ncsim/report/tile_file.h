// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file with the result for one tile of a part: options, input files, and the data for cda::Tiles.
// The file ends with a digest, which reveals an incomplete or changed file.
#pragma once

#include "ncsim/report/file_digests.h"
#include "ncsim/simulation/plan.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {

/// Options and input files of a tile.
struct TileHead {
    /// Arguments of `ncsim run` or `check`, without the output files.
    std::vector<std::string> words;
    FileDigests files;  ///< Files that were read.
    std::uint32_t tile = 0, of = 1;
    /// False if, for example, a whole folder was searched: then equal files do not prove that a new
    /// run would read the same files.
    bool knows_all_files = true;
    bool operator==(const TileHead&) const = default;
};

/// Content of a file.
struct TileFile {
    TileHead head;
    /// The motions that met the stock and that this tile counts.
    std::vector<simulation::StockContact> stock_contacts;
    std::string evidence;  ///< For `check`: lines of verify::bytes_of(), none of which is empty.
    std::string tile;      ///< Output of TreeCda::write_tile; for `check`, possibly empty.
    std::string digest;    ///< Digest of all preceding bytes, in a file that was read.
};

/// Returns "tile-0003-of-0064.nctile".
std::string tile_file_name(std::uint32_t tile, std::uint32_t of);

/// Returns the bytes of a file. `digest_of` returns SHA-256 in hexadecimal.
using Digest = std::string (*)(std::string_view);
std::string bytes_of(const TileFile& file, Digest digest_of);
/// Parses the bytes of a file.
/// Throws: std::runtime_error with `name` if the file is not a tile, is incomplete, or was written
///     by another version.
TileFile tile_file_from(std::string bytes, const std::string& name, Digest digest_of);

/// Returns the indices of the files that together are all tiles of a part, each once, in the order
/// of the tiles. `names[i]` is the name of files[i]. Only heads and digests are compared.
/// Throws: std::runtime_error with the name of the file if a tile is missing, if two files of a
///     tile differ, or if the program, the options or the input files differ from those of the
///     first file.
std::vector<std::size_t> order_tiles(const std::vector<TileFile>& files,
                                     const std::vector<std::string>& names);

}  // namespace ncsim::report
