// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the NC programs of a folder, and accounts for everything else in it.
#pragma once

#include "ncsim/report/scope.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

struct ProgramFolder {
    std::vector<std::string> programs;      ///< By name.
    std::vector<report::LeftOut> left_out;  ///< By name.
};

/// Lists the files in `folder` and below. A regular file is a program if its name or its text says
/// so (gcode::names_program, gcode::kind_of_text); of one that cannot be opened that is unknown, so
/// it counts as a program, which then cannot be read. Folders of version control are left out
/// whole. Guarantees: opens regular files only, and follows no link out of the folder. Throws:
/// std::runtime_error if a folder cannot be read.
ProgramFolder programs_in_folder(const std::string& folder);

/// Returns why the file at `path` is no program; nothing if it is one, is missing, or cannot be
/// opened.
std::optional<std::string> why_no_program(const std::string& path);

/// Returns whether the program at `path` only acts when another one calls it
/// (gcode::is_subprogram_text).
bool is_subprogram_file(const std::string& path);

}  // namespace ncsim::setup
