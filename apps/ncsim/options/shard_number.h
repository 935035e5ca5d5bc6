// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::app {

/// Which part of a list is this one's? From 0 to `of` - 1.
struct ShardNumber {
    std::uint32_t shard = 0, of = 1;
};

/// "3/200", or "auto": what the environment of a Slurm array task, a Kubernetes indexed job or a
/// job of GitLab says, where `of` may have to be told. Throws Refusal.
/// `option`: whose text it is.
ShardNumber shard_number(const std::string& text, std::uint32_t of, const char* option = "--shard");

}  // namespace ncsim::app
