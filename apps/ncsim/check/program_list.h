// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which programs a check is about: named on the command line, in a list, standing in a folder.
#pragma once

#include "ncsim/setup/input.h"

#include "options/check_options.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::app {

/// The programs in the order in which they are told: those of the command line, then those of
/// `--list`. A folder stands for the programs in it and below, by name. Throws std::runtime_error
/// if the list or a folder cannot be read or a folder has none.
std::vector<std::string> programs_of(const CheckOptions& options, setup::InputSet& inputs);

/// Those of them that are this shard's, ascending.
std::vector<std::size_t> share_of(const std::vector<std::string>& programs,
                                  const ShardNumber& number);

}  // namespace ncsim::app
