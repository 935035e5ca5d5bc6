// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge_tiles.h"

#include "ncsim/cda/tiles.h"
#include "ncsim/report/tile_file.h"
#include "ncsim/simulation/plan.h"

#include "options.h"
#include "run.h"
#include "tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

Options options_from(const std::vector<std::string>& words) {
    Command command = parse_options(words);
    if (const auto* farewell = std::get_if<Farewell>(&command)) {
        throw std::runtime_error("the tiles: " +
                                 farewell->text.substr(0, farewell->text.find('\n')));
    }
    auto* options = std::get_if<Options>(&command);
    if (!options) throw std::runtime_error("the tiles are of no ncsim run");
    return std::move(*options);
}

}  // namespace

int merge_tiles(const MergeOptions& merge, std::vector<std::string> files) {
    std::ranges::sort(files);
    if (!merge.json.empty() || !merge.sarif.empty() || !merge.junit.empty() ||
        !merge.write_baseline.empty() || merge.github || merge.notes || merge.exit_zero)
        throw std::runtime_error("tiles are of ncsim run, which writes no verdicts");
    std::vector<report::TileFile> read;
    for (const std::string& file : files)
        read.push_back(read_tile(file));
    read = report::in_order(std::move(read), files);

    std::vector<std::string> words = read[0].head.words;
    // Whoever wrote the tiles may say what is read, but not what is written.
    const Options of_tiles = options_from(words);
    if (!outputs_of(of_tiles).empty() || !of_tiles.frames.empty() || !of_tiles.tile.empty())
        throw std::runtime_error(fmt::format("'{}': it names files to be written", files[0]));
    for (const auto& [option, value] : merge.of_run)
        words.insert(words.begin() + 1, "--" + option + "=" + value);
    if (merge.quiet) words.insert(words.begin() + 1, "--quiet");
    Options options = options_from(words);
    options.tile_files = read[0].head.files;
    auto cut = std::make_shared<simulation::CutTiles>();
    std::vector<std::string> tiles;
    for (report::TileFile& file : read) {
        for (const auto& [motion, hulls] : file.met)
            cut->met.push_back({motion, hulls});
        tiles.push_back(std::move(file.tile));
    }
    std::ranges::sort(cut->met, {}, &simulation::MetStock::motion);
    try {
        cut->tiles = std::make_shared<const cda::Tiles>(std::move(tiles));
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(e.what());
    }
    options.tiles = std::move(cut);
    return run(std::move(options));
}

}  // namespace ncsim::app
