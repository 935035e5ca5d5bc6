// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings of ncsim.toml as options of commands.
#pragma once

#include "ncsim/setup/project_file.h"

#include "commands/options.h"

#include <functional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Returns a setting as words of a command line; file names are relative to `folder`, the folder of
/// the project.
/// Throws: std::runtime_error with file, line and column if `ncsim check` refuses the setting.
std::vector<std::string> words_of_setting(const setup::ProjectSetting& setting,
                                          const std::string& folder);

/// Returns the command line `words` with the settings whose options `accepts`.
std::vector<std::string> with_settings(std::vector<std::string> words,
                                       const std::vector<setup::ProjectSetting>& settings,
                                       const std::string& folder,
                                       const std::function<bool(const std::string&)>& accepts);

/// Parses a command line that was completed from ncsim.toml.
/// Throws: std::runtime_error if the command refuses an option.
Command parsed_again(const std::vector<std::string>& words);

/// Parses the command line. Commands that read one program take the options that the command line
/// lacks from the nearest ncsim.toml; `ncsim check` looks for the file of each program later.
/// Throws: std::runtime_error if the file is unreadable or has a setting that a command refuses.
Command options_with_project(const std::vector<std::string>& arguments);

}  // namespace ncsim::app
