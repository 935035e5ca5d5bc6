// SPDX-License-Identifier: GPL-3.0-or-later
//
// Project files, ncsim.toml: options shared by a folder of programs. See docs/ci.md, "A
// repository".
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/option_setting.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

inline constexpr const char* kProjectFileName = "ncsim.toml";

/// Content of a project file.
struct ProjectFile {
    struct Section {
        std::vector<std::string> files;  ///< Patterns of programs; empty for all programs.
        std::vector<OptionSetting> settings;
        std::vector<std::string> places{};  ///< Places of the patterns: "ncsim.toml:5:10".
    };
    std::string name;  ///< Path of the file.
    /// Folder of the file; patterns and file names are relative to this folder.
    std::string folder;
    std::vector<Section> sections;
};

/// Returns the nearest ncsim.toml in the folder of a program or above it, at most up to the folder
/// that contains .git. The path is relative if `program` is relative. "-" denotes a program in the
/// current folder.
std::optional<std::string> find_project_file(const std::string& program);

/// Reads a project file. Option names are not checked. Throws: std::runtime_error with file, line
/// and column.
ProjectFile read_project_file(const std::string& path, InputSet& inputs);

/// Returns the settings for a program. The last setting of an option in the file counts.
std::vector<OptionSetting> settings_for(const ProjectFile& project, const std::string& program);

/// Checks that every pattern matches a program: a program of `programs`, or a program below the
/// folder of the project. Folders with a project file or a repository of their own do not belong to
/// this project.
/// Throws: std::runtime_error with file, line and column if a pattern matches no program.
void expect_programs(const ProjectFile& project, const std::vector<std::string>& programs);

/// True if `path` matches a pattern such as "parts/**/op?_*.nc": * and ? match characters of a
/// name, ** any number of folders, including none.
/// Cost: O(pattern · path).
bool matches(std::string_view pattern, std::string_view path);

}  // namespace ncsim::setup
