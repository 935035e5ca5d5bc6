// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim.toml: what a folder of programs has in common, told once. docs/ci.md, "A repository".
#pragma once

#include "ncsim/setup/input.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

inline constexpr const char* kProjectFileName = "ncsim.toml";

/// One option of a command, as a file tells it.
struct ProjectSetting {
    std::string option;               ///< Its long name without dashes: "tool-table".
    std::vector<std::string> values;  ///< As on the command line.
    bool is_flag = false;             ///< true or false, with no value.
    bool is_on = true;                ///< A flag: its value.
    std::string where;                ///< "ncsim.toml:3:1", for messages.
};

struct ProjectFile {
    struct Section {
        std::vector<std::string> files;  ///< Patterns; none: all programs.
        std::vector<ProjectSetting> settings;
        std::vector<std::string> places{};  ///< Of the patterns: "ncsim.toml:5:10".
    };
    std::string name;    ///< Its path.
    std::string folder;  ///< Where it is; patterns and files it names are seen from there.
    std::vector<Section> sections;
};

/// The nearest ncsim.toml in the folder of a program or above it, no farther up than the folder
/// that holds .git. Relative where the program is. "-" stands for a program in the current folder.
std::optional<std::string> find_project_file(const std::string& program);

/// Throws std::runtime_error with file, line and column. Which options there are is not known here.
ProjectFile read_project_file(const std::string& path, InputSet& inputs);

/// What holds for a program: of settings of one option the last, in the order of the file.
std::vector<ProjectSetting> settings_for(const ProjectFile& project, const std::string& program);

/// Throws: std::runtime_error with file, line and column if a pattern matches no program: none of
/// `programs`, which are judged, and none below the folder of the project. A folder with a project
/// file or a repository of its own has no programs of this project.
void expect_programs(const ProjectFile& project, const std::vector<std::string>& programs);

/// "parts/**/op?_*.nc": * and ? stand for characters of one name, ** for any folders, also none.
/// O(pattern · path).
bool matches(std::string_view pattern, std::string_view path);

}  // namespace ncsim::setup
