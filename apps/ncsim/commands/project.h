// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings of ncsim.toml as options of commands.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/project_file.h"

#include "commands/options.h"

#include <functional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Returns a setting as words of a command line; file names are relative to `folder`, the folder of
/// the project.
/// Throws: std::runtime_error with file, line and column if `ncsim check` refuses the setting.
std::vector<std::string> words_of_setting(const setup::OptionSetting& setting,
                                          const std::string& folder);

/// Returns the job file: of the command line, otherwise of the settings of a project in `folder`.
std::string job_of(const ProgramOptions& options, const std::vector<setup::OptionSetting>& settings,
                   const std::string& folder);

/// Returns the command line `words` with the settings whose options `accepts`.
std::vector<std::string> with_settings(std::vector<std::string> words,
                                       const std::vector<setup::OptionSetting>& settings,
                                       const std::string& folder,
                                       const std::function<bool(const std::string&)>& accepts);

/// Values of a job file with precedence over ncsim.toml.
class JobValues {
public:
    /// Reads the job file `path`. No values if `path` is empty, or is no regular file.
    /// Throws: std::runtime_error as setup::read_job_file().
    JobValues(const std::string& path, setup::InputSet& inputs);

    /// Options in the job: machine, tool tables, accuracy, rules.
    const std::vector<setup::OptionSetting>& settings() const { return file_.settings; }
    const std::string& folder() const { return folder_; }
    /// Removes the values of `settings` that the job specifies, too: the same option, tool,
    /// variable or register. Adds a line to `overridden` for each removed value that differs.
    std::vector<setup::OptionSetting> without_own(std::vector<setup::OptionSetting> settings,
                                                  std::vector<std::string>& overridden) const;
    /// Returns a line for each value of the job, with its place, except the options `given`.
    std::vector<std::string> lines(const std::function<bool(const std::string&)>& given) const;

private:
    const setup::PlacedValue* value_of(const std::string& option, const std::string& value) const;

    setup::JobFile file_;
    std::string folder_;
};

/// Returns a line for --verbose about a setting: name, value, place.
std::string line_of(const setup::OptionSetting& setting);

/// Parses a command line that was completed from ncsim.toml.
/// Throws: std::runtime_error if the command refuses an option.
Command parsed_again(const std::vector<std::string>& words);

/// Parses the command line. Values that the command line lacks are those of the job file, then
/// those of the nearest ncsim.toml; `ncsim check` looks for the ncsim.toml of each program later.
/// With --verbose, prints each value with its place.
/// Throws: std::runtime_error if a file is unreadable or has a setting that a command refuses.
Command options_with_project(const std::vector<std::string>& arguments);

}  // namespace ncsim::app
