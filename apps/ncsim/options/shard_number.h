// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number of a shard or tile, from text or from the environment.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::app {

/// Index of a part of a list, from 0 to `of` - 1.
struct ShardNumber {
    std::uint32_t shard = 0, of = 1;
};

/// Parses "3/200", or for "auto" the environment of a Slurm array task or a GitLab job. `option`:
/// name of the option in messages. Throws: Refusal.
ShardNumber shard_number(const std::string& text, const char* option);

/// Checks --tile and --tile-out, and parses --tile; the whole part if both are empty.
/// Throws: Refusal.
ShardNumber tile_number(const std::string& tile, const std::string& folder);

}  // namespace ncsim::app
