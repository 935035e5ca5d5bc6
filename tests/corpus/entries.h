// SPDX-License-Identifier: GPL-3.0-or-later
//
// The programs of a folder: those that DIR/INDEX.tsv names, or every file that looks like one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::corpus {

struct Entry {
    std::filesystem::path path;
    std::string name;
    std::string kind = "?";
    std::string status = "none";      ///< What the reference interpreter said.
    std::filesystem::path reference;  ///< What it made of it; empty if nothing.
};

/// By name where there is no index, else as it has them. A program is the only one of itself.
std::vector<Entry> entries_of(const std::filesystem::path& directory);

/// Empty if it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace ncsim::corpus
