// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiles.h"

#include "ncsim/cda/tiles.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/simulation/take_machine.h"

#include "console.h"
#include "options.h"
#include "output.h"
#include "plan_options.h"
#include "progress.h"
#include "run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

report::TileFile read_tile(const std::string& path) {
    // Larger than what others read, and no input that an output of theirs could be.
    constexpr std::uintmax_t kMost = 1'000'000'000'000;
    setup::InputSet inputs;
    return report::tile_file_from(inputs.read(path, kMost), path, setup::digest_of);
}

// Is it this tile, made of files that are still what they were?
bool is_done(const std::string& path, const report::TileHead& head, setup::InputSet& inputs) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    try {
        const report::TileFile file = read_tile(path);
        return file.head.words == head.words && file.head.tile == head.tile &&
               file.head.of == head.of && std::ranges::all_of(file.head.files, [&](const auto& f) {
                   return setup::digest_of_file(f.first, inputs) == f.second;
               });
    } catch (const std::runtime_error&) {
        return false;
    }
}

}  // namespace

int run_tile(Options options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    if (!options.machine.empty()) inputs.expect(options.machine);
    const ShardNumber& number = options.number;
    report::TileFile file;
    file.head = {options.words, {}, number.shard, number.of};
    const std::string path =
        (fs::path(options.tile_out) / report::tile_file_name(number.shard, number.of)).string();
    const auto say_done = [&](const char* what) {
        put_text(fmt::format("tile {} of {} {}: {}\n", number.shard, number.of, what,
                             report::shown_path(path)));
    };
    if (!options.redo && is_done(path, file.head, inputs)) {
        say_done("was cut before");
        return kClean;
    }
    std::error_code error;
    fs::create_directories(options.tile_out, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", options.tile_out, error.message()));
    }
    outputs.reserve(path);

    setup::RecordedInput read(inputs);
    simulation::Plan plan = plan_for(options, read);
    if (!options.machine.empty())
        (void)simulation::take_machine(plan, setup::read_machine(options.machine, read));
    const simulation::Survey survey = simulation::survey(plan);
    simulation::coarsen(plan, survey, options.tolerance_told, options.tool_tolerance_told);
    if (!survey.is_ready()) {
        print_findings(plan.job.program, survey.diagnostics);
        say("ncsim: the program was not simulated\n");
        return kFindings;
    }
    plan.tile = cda::TileNumber{number.shard, number.of};
    Progress progress(survey.moves, !options.quiet && ::isatty(STDERR_FILENO) != 0);
    const simulation::Simulation simulation =
        simulation::simulate(plan, survey, {}, [&](std::uint64_t done) { progress.update(done); });
    if (!read.knows_all())
        throw std::runtime_error("--tile: a subprogram was looked for in a whole folder");
    file.head.files = read.files();
    for (const simulation::MetStock& met : simulation.met)
        file.met.emplace_back(met.motion, met.hulls);
    std::ostringstream bytes;
    simulation.part->write_tile(bytes);
    file.tile = std::move(bytes).str();
    outputs.write(path,
                  [&](std::ostream& out) { out << report::bytes_of(file, setup::digest_of); });
    outputs.commit();
    progress.hide();
    say_done("was cut");
    return kClean;
}

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
    for (const auto& [option, value] : merge.of_run) {
        // What was told last counts nowhere else.
        words.insert(words.begin() + 1, "--" + option + "=" + value);
    }
    if (merge.quiet) words.insert(words.begin() + 1, "--quiet");
    Command command = parse_options(words);
    if (const auto* farewell = std::get_if<Farewell>(&command))
        throw std::runtime_error("the tiles: " +
                                 farewell->text.substr(0, farewell->text.find('\n')));
    auto* options = std::get_if<Options>(&command);
    if (!options) throw std::runtime_error("the tiles are of no ncsim run");
    options->tile_files = read[0].head.files;
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
    options->tiles = std::move(cut);
    return run(std::move(*options));
}

void expect_same_files(const report::FileDigests& then, const report::FileDigests& now) {
    for (const auto& [file, digest] : then) {
        const auto found = now.find(file);
        if (found == now.end() || found->second != digest)
            throw std::runtime_error(
                fmt::format("'{}' is not what it was when the tiles were cut", file));
    }
    if (then.size() != now.size())
        throw std::runtime_error("other files are read than when the tiles were cut");
}

}  // namespace ncsim::app
