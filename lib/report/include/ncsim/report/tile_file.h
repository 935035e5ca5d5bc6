// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tile of a part in a file: what was asked, of which files, and what cda::Tiles takes. The file
// ends with a digest, so one that was cut off or changed is known as such.
#pragma once

#include "ncsim/report/file_digests.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::report {

struct TileHead {
    std::vector<std::string> words;  ///< Of `ncsim run` or `check`, without where results go.
    FileDigests files;               ///< What was read.
    std::uint32_t tile = 0, of = 1;
    /// A whole folder was looked through, say: that the files are the same does not tell that what
    /// is read would be.
    bool knows_all_files = true;
    bool operator==(const TileHead&) const = default;
};

struct TileFile {
    TileHead head;
    /// Motions, from 1, and how many of their hulls met the stock: of those that this tile counts.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> met;
    std::string evidence;  ///< Of `check`: lines of verify::bytes_of(); none of them is empty.
    std::string tile;      ///< As WorkpieceModel::write_tile wrote it; of `check`, maybe nothing.
    std::string digest;    ///< Of all before it, of a file that was read.
};

/// "tile-0003-of-0064.nctile"
std::string tile_file_name(std::uint32_t tile, std::uint32_t of);

/// All of a file. `digest_of`: SHA-256 in hexadecimal.
using Digest = std::string (*)(std::string_view);
std::string bytes_of(const TileFile& file, Digest digest_of);
/// And back. Throws std::runtime_error, naming `name`, if it is no such file, is not whole, or was
/// written by another version.
TileFile tile_file_from(std::string bytes, const std::string& name, Digest digest_of);

/// Which of the files are all tiles of a part, each once, in their order. Throws
/// std::runtime_error, naming the file, if one is missing or there twice with other bytes, or is of
/// another program, other options or other files than the first. `names[i]` is that of files[i].
/// Heads and digests are looked at alone.
std::vector<std::size_t> in_order(const std::vector<TileFile>& files,
                                  const std::vector<std::string>& names);

}  // namespace ncsim::report
