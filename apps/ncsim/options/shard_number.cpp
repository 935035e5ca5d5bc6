// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses the number of a shard or tile.
#include "options/shard_number.h"

#include "ncsim/base/number_text.h"
#include "ncsim/cda/tile_number.h"

#include "options/refusal.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string_view>

namespace ncsim::app {

namespace {

std::optional<std::uint32_t> from_environment(const char* name) {
    const char* text = std::getenv(name);
    return text ? number_in<std::uint32_t>(text) : std::nullopt;
}

}  // namespace

ShardNumber shard_number(const std::string& text, const char* option) {
    if (text == "auto") {
        struct Service {
            const char *index, *first, *count;
        };
        // Slurm counts from the beginning of the array, GitLab from 1.
        for (const Service& s :
             {Service{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_COUNT"},
              Service{"CI_NODE_INDEX", nullptr, "CI_NODE_TOTAL"}}) {
            const auto index = from_environment(s.index);
            if (!index) continue;
            const std::uint32_t first = s.first ? from_environment(s.first).value_or(0) : 1;
            const auto of = from_environment(s.count);
            if (!of) {
                throw Refusal{fmt::format("{0} auto: {1} is set, but {2} is not: {0} I/N", option,
                                          s.index, s.count)};
            }
            if (*index < first || *index - first >= *of) {
                throw Refusal{fmt::format("{} auto: {} is {}, of {} from {} on", option, s.index,
                                          *index, *of, first)};
            }
            return {*index - first, *of};
        }
        throw Refusal{
            fmt::format("{} auto: neither SLURM_ARRAY_TASK_ID nor CI_NODE_INDEX is set", option)};
    }
    const std::size_t slash = text.find('/');
    const auto shard = number_in<std::uint32_t>(std::string_view(text).substr(0, slash));
    const auto count = slash == std::string::npos
                           ? std::nullopt
                           : number_in<std::uint32_t>(std::string_view(text).substr(slash + 1));
    constexpr std::uint32_t kMost = 1'000'000;
    if (!shard || !count || *count == 0 || *count > kMost || *shard >= *count) {
        throw Refusal{
            fmt::format("{} '{}': expected i/n with i from 0 to n-1, or auto", option, text)};
    }
    return {*shard, *count};
}

ShardNumber tile_number(const std::string& tile, const std::string& folder) {
    if (tile.empty() != folder.empty()) {
        throw Refusal{tile.empty() ? "--tile-out: of which tile? --tile I/N"
                                   : "--tile: where to is its result to go? --tile-out DIR"};
    }
    if (tile.empty()) return {};
    const ShardNumber number = shard_number(tile, "--tile");
    if (number.of > cda::kMostTiles)
        throw Refusal{fmt::format("--tile '{}': {} tiles at most", tile, cda::kMostTiles)};
    return number;
}

}  // namespace ncsim::app
