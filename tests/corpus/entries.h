// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a folder: the programs in DIR/INDEX.tsv, or every file that looks like a program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::corpus {

struct Entry {
    std::filesystem::path path;
    std::string name;
    std::string kind = "?";
    std::string status = "none";      ///< Verdict of the reference interpreter.
    std::filesystem::path reference;  ///< Output of the reference interpreter; empty if there is
                                      ///< none.
};

/// Returns the programs in the order of the index, or sorted by name if there is no index. For the
/// path of a program, returns only that program.
std::vector<Entry> entries_of(const std::filesystem::path& directory);

/// Returns the content of a file; empty if the file cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace ncsim::corpus
