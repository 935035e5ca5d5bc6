// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings of the programs of a check: the command line for all programs, and for each program the
// ncsim.toml in a folder above.
#pragma once

#include "ncsim/report/baseline.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/project_file.h"
#include "ncsim/simulation/program_check.h"

#include "check/result_cache.h"
#include "options/check_options.h"

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ncsim::app {

struct CheckSettings {
    CheckOptions options;
    std::string project;  ///< The ncsim.toml with some of the settings; empty: none.
    std::string label;    ///< "set-up 2, back" for a job with several set-ups; otherwise empty.
    simulation::VerificationOptions verification_options;
    std::optional<simulation::Design> design;
    std::shared_ptr<const report::Baseline> baseline;
    report::EntryOptions entries;
    std::string key;                   ///< All values that determine verdicts, except the programs.
    std::optional<ResultCache> cache;  ///< Present with --cache.

    /// Returns further values that determine the verdict of this program only.
    std::string key_of_program(const std::string& program) const {
        return baseline ? baseline->key_of_program(program) : "";
    }
};

/// Settings of all programs. Reads machines, designs and projects; programs with equal settings
/// share an object.
class SettingsOfPrograms {
public:
    /// Reads the settings.
    /// Throws: std::runtime_error, with file, line and column of a fault in a project.
    SettingsOfPrograms(const CheckOptions& specified, const std::vector<std::string>& programs,
                       setup::InputSet& inputs);

    CheckSettings& of(std::size_t program) { return settings_[number_of_[program]]; }
    /// Returns all values that determine verdicts, except the programs.
    std::string key() const;
    /// Returns the entries of baselines for programs that no longer exist, one line a program.
    std::string lost_programs() const;
    /// Returns a line for each value of an ncsim.toml that a job file replaces; with --verbose, for
    /// each setting with its place, too.
    std::string notes() const;

private:
    std::string label_of_step(std::size_t step) const;
    const setup::ProjectFile* project_of(const std::string& program);
    void fill(CheckSettings& made, const setup::ProjectFile* project,
              const std::vector<setup::OptionSetting>& settings, std::optional<std::size_t> step);
    std::shared_ptr<const report::Baseline> baseline_of(const CheckOptions& options);

    const CheckOptions& specified_;
    setup::InputSet& inputs_;
    bool many_;
    std::map<std::string, std::optional<std::string>> project_above_;  // by folder
    std::map<std::string, setup::ProjectFile> projects_;
    std::map<std::string, std::shared_ptr<const report::Baseline>> baselines_;
    std::map<std::vector<std::string>, std::shared_ptr<LeftStocks>> left_stocks_;  // by words
    std::set<std::string> notes_;
    std::deque<CheckSettings> settings_;
    std::vector<std::size_t> number_of_;
};

}  // namespace ncsim::app
