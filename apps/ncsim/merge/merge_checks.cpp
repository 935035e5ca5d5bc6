// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges tiles of `ncsim check`.
#include "merge/merge_checks.h"

#include "ncsim/verify/evidence.h"

#include "check/check_command.h"
#include "run/tile.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace ncsim::app {

Command command_of_tiles(const std::vector<std::string>& words) {
    Command command = parse_options(words);
    if (const auto* early_exit = std::get_if<EarlyExit>(&command)) {
        throw std::runtime_error("the tiles: " +
                                 early_exit->text.substr(0, early_exit->text.find('\n')));
    }
    return command;
}

int merge_checks(const MergeOptions& merge, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, bool has_part,
                 const std::function<std::string(std::size_t)>& read) {
    std::vector<std::string> words = files[order[0]].head.words;
    // Tile files may specify inputs, but no outputs, because their author is not trusted.
    const auto of_tiles = std::get<CheckOptions>(command_of_tiles(words));
    if (!outputs_of(of_tiles).empty() || !of_tiles.tile.empty() || !of_tiles.shard.empty() ||
        of_tiles.github || of_tiles.exit_zero || !of_tiles.cache.empty() ||
        !of_tiles.list.empty() || of_tiles.programs.size() != 1)
        throw std::runtime_error("the tiles say where reports go, or name many programs");
    const auto tell = [&words](const std::string& option) {
        words.insert(words.begin() + 1, "--" + option);
    };
    for (const auto& [option, value] : merge.of_run) {
        if (option != "threads") {
            throw std::runtime_error(fmt::format("--{}: tiles of ncsim check are no part", option));
        }
        tell("threads=" + value);
    }
    for (const auto& [option, file] : {std::pair{"json", &merge.json},
                                       {"sarif", &merge.sarif},
                                       {"junit", &merge.junit},
                                       {"write-baseline", &merge.write_baseline}}) {
        if (!file->empty()) tell(std::string(option) + "=" + *file);
    }
    for (const auto& [option, is_specified] : {std::pair{"github", merge.github},
                                               {"exit-zero", merge.exit_zero},
                                               {"notes", merge.notes},
                                               {"quiet", merge.quiet}}) {
        if (is_specified) tell(option);
    }
    auto options = std::get<CheckOptions>(command_of_tiles(words));
    options.tile_files = files[order[0]].head.files;
    auto seen = std::make_shared<simulation::TileResults>();
    try {
        std::vector<verify::Evidence> evidence;
        evidence.reserve(order.size());
        for (const std::size_t file : order)
            evidence.push_back(verify::evidence_from(files[file].evidence));
        seen->evidence =
            std::make_shared<const verify::Evidence>(verify::together(std::move(evidence)));
        if (has_part) seen->cut = tiles_in_order(files, order, read, options.threads);
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(e.what());
    }
    options.tiles = std::move(seen);
    return run(std::move(options));
}

}  // namespace ncsim::app
