// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile.h"

#include "ncsim/cda/tile_number.h"
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
#include "output.h"
#include "plan_options.h"
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace fs = std::filesystem;

report::TileFile read_tile(const std::string& path) {
    // Larger than what others read, and no input that an output of theirs could be.
    constexpr std::uintmax_t kMost = 1'000'000'000'000;
    setup::InputSet inputs;
    return report::tile_file_from(inputs.read(path, kMost), path, setup::digest_of);
}

namespace {

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

std::optional<report::TileFile> cut_tile(const Options& options, setup::InputSet& inputs,
                                         bool may_say) {
    const ShardNumber& number = options.number;
    setup::RecordedInput read(inputs);
    simulation::Plan plan = plan_for(options, read);
    if (!options.machine.empty())
        (void)simulation::take_machine(plan, setup::read_machine(options.machine, read));
    const simulation::Survey survey = simulation::survey(plan);
    simulation::coarsen(plan, survey, options.tolerance_told, options.tool_tolerance_told);
    if (!survey.is_ready()) {
        if (!may_say) return std::nullopt;
        print_findings(plan.job.program, survey.diagnostics);
        say("ncsim: the program was not simulated\n");
        return std::nullopt;
    }
    plan.tile = cda::TileNumber{number.shard, number.of};
    plan.keep_boundary = plan.keep_paths = false;  // that is for who puts tiles together
    Progress progress(survey.moves, may_say && !options.quiet && ::isatty(STDERR_FILENO) != 0);
    const simulation::Simulation simulation =
        simulation::simulate(plan, survey, {}, [&](std::uint64_t done) { progress.update(done); });
    if (!read.knows_all())
        throw std::runtime_error("--tile: a subprogram was looked for in a whole folder");
    report::TileFile file;
    file.head = {options.words, read.files(), number.shard, number.of};
    for (const simulation::MetStock& met : simulation.met)
        file.met.emplace_back(met.motion, met.hulls);
    std::ostringstream bytes;
    simulation.part->write_tile(bytes);
    file.tile = std::move(bytes).str();
    progress.hide();
    return file;
}

int run_tile(Options options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    if (!options.machine.empty()) inputs.expect(options.machine);
    const ShardNumber& number = options.number;
    const report::TileHead head{options.words, {}, number.shard, number.of};
    const std::string path =
        (fs::path(options.tile_out) / report::tile_file_name(number.shard, number.of)).string();
    const auto say_done = [&](const char* what) {
        put_text(fmt::format("tile {} of {} {}: {}\n", number.shard, number.of, what,
                             report::shown_path(path)));
    };
    if (!options.redo && is_done(path, head, inputs)) {
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

    const std::optional<report::TileFile> file = cut_tile(options, inputs, true);
    if (!file) return kFindings;
    outputs.write(path,
                  [&](std::ostream& out) { out << report::bytes_of(*file, setup::digest_of); });
    outputs.commit();
    say_done("was cut");
    return kClean;
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
