// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for the NC programs of a folder, with reasons for all further files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// An entry of a folder or a list that is not a program.
struct ExcludedEntry {
    std::string path;
    std::string why;  ///< Kind of the entry: "binary file", "FIFO", "link out of the folder" …
    bool operator==(const ExcludedEntry&) const = default;
};

/// Programs of a folder, and the files left out.
struct ProgramFolder {
    std::vector<std::string> programs;    ///< Sorted by name.
    std::vector<ExcludedEntry> excluded;  ///< Sorted by name.
};

/// Lists the files in `folder` and below. A regular file is a program if its name or its text
/// indicates a program (gcode::names_program, gcode::kind_of_text). A file that cannot be opened
/// counts as a program, which then cannot be read. Folders of version control are left out
/// completely.
/// Guarantees: opens regular files only, and follows no link out of the folder.
/// Throws: std::runtime_error if a folder cannot be read.
ProgramFolder programs_in_folder(const std::string& folder);

/// Returns why the file at `path` is not a program; empty if the file is a program, is missing, or
/// cannot be opened.
std::optional<std::string> why_no_program(const std::string& path);

/// True if the program at `path` only acts when a second program calls it
/// (gcode::is_subprogram_text).
bool is_subprogram_file(const std::string& path);

}  // namespace ncsim::setup
