// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds for which programs of a check: the command line for all of them, and for each the
// ncsim.toml above it.
#pragma once

#include "ncsim/report/baseline.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/project_file.h"
#include "ncsim/simulation/check.h"

#include "check/result_cache.h"
#include "options/check_options.h"

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

struct CheckSettings {
    CheckOptions options;
    std::string project;  ///< The ncsim.toml that told some of them; empty: none.
    simulation::Questions questions;
    std::optional<simulation::Design> design;
    std::shared_ptr<const report::Baseline> baseline;
    report::EntryOptions entries;
    std::string key;                   ///< All that decides verdicts beside the programs.
    std::optional<ResultCache> cache;  ///< If there is one.

    /// What else decides the verdict of a program, and of no other.
    std::string about(const std::string& program) const {
        return baseline ? baseline->about(program) : "";
    }
};

/// Reads what they name: machines, designs, projects. Programs of the same settings share them.
class SettingsOfPrograms {
public:
    /// Throws std::runtime_error, with file, line and column where a project is wrong.
    SettingsOfPrograms(const CheckOptions& told, const std::vector<std::string>& programs,
                       setup::InputSet& inputs);

    CheckSettings& of(std::size_t program) { return settings_[number_of_[program]]; }
    /// All that decides verdicts beside the programs.
    std::string key() const;
    /// What the baselines say of programs that are there no more, a line a program.
    std::string lost_programs() const;

private:
    const setup::ProjectFile* project_of(const std::string& program);
    void fill(CheckSettings& made, const setup::ProjectFile* project,
              const std::vector<setup::ProjectSetting>& settings);
    std::shared_ptr<const report::Baseline> baseline_of(const CheckOptions& options);

    const CheckOptions& told_;
    setup::InputSet& inputs_;
    bool many_;
    std::map<std::string, std::optional<std::string>> project_above_;  // of a folder
    std::map<std::string, setup::ProjectFile> projects_;
    std::map<std::string, std::shared_ptr<const report::Baseline>> baselines_;
    std::deque<CheckSettings> settings_;
    std::vector<std::size_t> number_of_;
};

}  // namespace ncsim::app
