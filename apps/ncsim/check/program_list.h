// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the programs of a check: from the command line, a list file, and folders.
#pragma once

#include "ncsim/report/scope.h"
#include "ncsim/setup/input.h"

#include "options/check_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::app {

/// Programs of a check, and their origin.
struct ProgramList {
    /// In the order of naming: the command line, then `--list`. Programs in a folder are sorted by
    /// name.
    std::vector<std::string> programs;
    /// For each program: found in a folder or a list, and acts only if a different program calls
    /// it.
    std::vector<bool> is_subprogram;
    std::vector<report::ExcludedEntry> excluded;  ///< Entries of folders and of `--list`.
};

/// Returns the programs of `options`. A folder stands for the programs in it and below. Outputs of
/// the same run are skipped. For a job alone, the chosen programs of the job; options.steps then
/// has their steps. Throws: std::runtime_error if the list or a folder cannot be read, or has no
/// programs.
ProgramList programs_of(CheckOptions& options, setup::InputSet& inputs);

/// Returns the indices of the programs of this shard, ascending.
std::vector<std::size_t> share_of(const std::vector<std::string>& programs,
                                  const ShardNumber& number);

}  // namespace ncsim::app
