// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a tile.
#include "run/tile.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/cda/tile_number.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/stock_history.h"
#include "ncsim/simulation/survey.h"

#include "options/plan_options.h"
#include "system/console.h"
#include "system/output.h"
#include "system/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace fs = std::filesystem;

report::TileFile read_tile(const std::string& path) {
    // The limit is larger than for further inputs. The InputSet is separate, because no output may
    // conflict with a tile file.
    constexpr std::uintmax_t kMost = 1'000'000'000'000;
    setup::InputSet inputs;
    return report::tile_file_from(inputs.read(path, kMost), path, setup::digest_of);
}

TilePlace::TilePlace(report::TileHead head, std::string folder)
    : head_(std::move(head)),
      folder_(std::move(folder)),
      path_((fs::path(folder_) / report::tile_file_name(head_.tile, head_.of)).string()) {}

bool TilePlace::is_done(setup::InputSet& inputs) const {
    std::error_code ignored;
    if (!fs::is_regular_file(path_, ignored)) return false;
    try {
        const report::TileFile file = read_tile(path_);
        return file.head.knows_all_files && file.head.words == head_.words &&
               file.head.tile == head_.tile && file.head.of == head_.of &&
               std::ranges::all_of(file.head.files, [&](const auto& f) {
                   return setup::digest_of_file(f.first, inputs) == f.second;
               });
    } catch (const std::runtime_error&) {
        return false;
    }
}

void TilePlace::reserve(OutputSet& outputs) const {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", folder_, error.message()));
    }
    outputs.reserve(path_);
}

void TilePlace::write(const report::TileFile& file, OutputSet& outputs) const {
    outputs.write(path_,
                  [&](std::ostream& out) { out << report::bytes_of(file, setup::digest_of); });
    outputs.commit();
}

int TilePlace::report_done(const char* what) const {
    put_text(
        fmt::format("tile {} of {} {}: {}\n", head_.tile, head_.of, what, printable_path(path_)));
    return kClean;
}

std::shared_ptr<const simulation::CutTiles> tiles_in_order(
    const std::vector<report::TileFile>& files, const std::vector<std::size_t>& order,
    const cda::Tiles::Read& read, unsigned threads) {
    auto cut = std::make_shared<simulation::CutTiles>();
    for (const std::size_t file : order)
        std::ranges::copy(files[file].stock_contacts, std::back_inserter(cut->stock_contacts));
    std::ranges::sort(cut->stock_contacts, {}, &simulation::StockContact::motion);
    try {
        cut->tiles = std::make_shared<const cda::Tiles>(order.size(), read, threads);
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(e.what());
    }
    return cut;
}

std::optional<report::TileFile> cut_tile(const Options& options, setup::InputSet& inputs,
                                         bool may_say) {
    const ShardNumber& number = options.number;
    setup::RecordedInput read(inputs);
    simulation::Plan plan = plan_for(options, read);
    if (!options.machine.empty())
        (void)simulation::apply_machine(plan, setup::read_machine(options.machine, read));
    const simulation::Survey survey = simulation::survey(plan);
    simulation::coarsen(plan, survey, options.tolerance_specified,
                        options.tool_tolerance_specified);
    if (!survey.is_ready()) {
        if (!may_say) return std::nullopt;
        print_findings(plan.job.program, survey.diagnostics);
        print_error("ncsim: the program was not simulated\n");
        return std::nullopt;
    }
    plan.tile = cda::TileNumber{number.shard, number.of};
    plan.keep_boundary = plan.keep_paths = false;  // left to the merge of tiles
    Progress progress(survey.moves, may_say && !options.quiet && ::isatty(STDERR_FILENO) != 0);
    simulation::Verification nothing;
    nothing.history = simulation::read_stock_history(*survey.stock);
    const simulation::Simulation simulation = simulation::simulate(
        plan, survey, nothing, [&](std::uint64_t done) { progress.update(done); });
    report::TileFile file;
    file.head = {options.words, read.files(), number.shard, number.of, read.knows_all()};
    file.stock_contacts = simulation.stock_contacts;
    file.tile = simulation::tile_data(*simulation.part);
    progress.hide();
    return file;
}

int run_tile(const Options& options) {
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    const ShardNumber& number = options.number;
    const TilePlace place({options.words, {}, number.shard, number.of}, options.tile_out);
    if (place.is_done(inputs)) return place.report_done("was cut before");
    place.reserve(outputs);
    const std::optional<report::TileFile> file = cut_tile(options, inputs, true);
    if (!file) return kFindings;
    place.write(*file, outputs);
    return place.report_done("was cut");
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
