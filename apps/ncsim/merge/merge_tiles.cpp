// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges tiles of `ncsim run`.
#include "merge/merge_tiles.h"

#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"

#include "merge/merge_checks.h"
#include "run/mesh_folder.h"
#include "run/run.h"
#include "run/tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

Options options_from(const std::vector<std::string>& words) {
    Command command = command_of_tiles(words);
    auto* options = std::get_if<Options>(&command);
    if (!options) throw std::runtime_error("the tiles are of no ncsim run");
    return std::move(*options);
}

}  // namespace

int merge_tiles(const MergeOptions& merge, std::vector<std::string> files) {
    std::ranges::sort(files);
    // Keeps only the heads of the files; the contents are read when needed.
    std::vector<report::TileFile> read;
    bool has_part = false;
    for (const std::string& file : files) {
        read.push_back(read_tile(file));
        has_part |= !read.back().tile.empty();
        std::string().swap(read.back().tile);  // an assignment would keep the memory
    }
    const std::vector<std::size_t> order = report::order_tiles(read, files);

    const auto read_again = [&](std::size_t tile) {
        const std::size_t file = order[tile];
        report::TileFile again = read_tile(files[file]);
        if (again.digest != read[file].digest)
            throw std::runtime_error(fmt::format("'{}' was changed meanwhile", files[file]));
        return std::move(again.tile);
    };
    std::vector<std::string> words = read[0].head.words;
    if (!words.empty() && words[0] == "check")
        return merge_checks(merge, read, order, has_part, read_again);
    if (!merge.json.empty() || !merge.sarif.empty() || !merge.junit.empty() ||
        !merge.write_baseline.empty() || merge.github || merge.notes || merge.exit_zero)
        throw std::runtime_error("these tiles are of ncsim run, which writes no verdicts");
    // Tile files may specify inputs, but no outputs, because their author is not trusted.
    const Options of_tiles = options_from(words);
    if (!outputs_of(of_tiles).empty() || !of_tiles.frames.empty() || !of_tiles.tile.empty())
        throw std::runtime_error(fmt::format("'{}': it names files to be written", files[0]));
    std::string mesh_folder;
    for (const auto& [option, value] : merge.of_run) {
        if (option == "gltf" && names_a_folder(value)) {
            mesh_folder = value;
        } else {
            words.insert(words.begin() + 1, fmt::format("--{}={}", option, value));
        }
    }
    if (merge.quiet) words.insert(words.begin() + 1, "--quiet");
    Options options = options_from(words);
    options.mesh_folder = mesh_folder;
    return run_of_tiles(std::move(options), read, order, read_again);
}

int run_of_tiles(Options options, const std::vector<report::TileFile>& files,
                 const std::vector<std::size_t>& order, const cda::Tiles::Read& read) {
    options.tile_files = files[order[0]].head.files;
    options.tiles = tiles_in_order(files, order, read, options.threads);
    return run(std::move(options));
}

}  // namespace ncsim::app
