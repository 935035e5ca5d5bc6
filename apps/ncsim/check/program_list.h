// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which programs a check is about: named on the command line, in a list, standing in a folder.
#pragma once

#include "ncsim/report/scope.h"
#include "ncsim/setup/input.h"

#include "options/check_options.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::app {

/// The programs of a check, and what was named with them.
struct ProgramList {
    /// In the order in which they are named: first the command line, then `--list`. Programs of a
    /// folder come by name.
    std::vector<std::string> programs;
    /// For each program: found in a folder or a list, and only acts when another one calls it.
    std::vector<bool> is_subprogram;
    std::vector<report::LeftOut> left_out;  ///< Entries of folders and of `--list`.
};

/// Returns the programs of `options`. A folder stands for the programs in it and below. Outputs of
/// the same run are passed over.
/// Throws: std::runtime_error if the list or a folder cannot be read, or has no programs.
ProgramList programs_of(const CheckOptions& options, setup::InputSet& inputs);

/// Returns the indices of the programs of this shard, ascending.
std::vector<std::size_t> share_of(const std::vector<std::string>& programs,
                                  const ShardNumber& number);

}  // namespace ncsim::app
