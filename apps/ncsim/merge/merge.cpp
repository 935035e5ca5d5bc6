// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects the kind of merge.
#include "merge/merge.h"

#include "ncsim/report/shard.h"

#include "check/reports.h"
#include "merge/merge_tiles.h"
#include "system/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kTile = ".nctile";

// Returns the results in folders, and the named files.
std::vector<std::string> files_of(const std::vector<std::string>& sources) {
    std::vector<std::string> files;
    for (const std::string& source : sources) {
        std::error_code error;
        if (!fs::is_directory(source, error)) {
            files.push_back(source);
            continue;
        }
        for (fs::directory_iterator entry(source, error), end; !error && entry != end;
             entry.increment(error)) {
            const std::string kind = entry->path().extension().string();
            if (kind == ".ndjson" || kind == kTile) files.push_back(entry->path().string());
        }
        if (error) {
            throw std::runtime_error(
                fmt::format("cannot read the folder '{}': {}", source, error.message()));
        }
    }
    return files;
}

}  // namespace

int run(MergeOptions options) {
    const std::vector<std::string> files = files_of(options.sources);
    const auto tiles = std::ranges::count_if(
        files, [](const std::string& file) { return fs::path(file).extension() == kTile; });
    if (tiles > 0 && static_cast<std::size_t>(tiles) == files.size())
        return merge_tiles(options, files);
    if (tiles > 0) throw std::runtime_error("shards and tiles are not put together");
    if (!options.of_run.empty()) {
        throw std::runtime_error(fmt::format("--{} is written of tiles, and there are none",
                                             options.of_run.front().first));
    }
    setup::InputSet inputs(files);
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    for (const std::string& path : outputs_of(options))
        outputs.reserve(path);
    const report::Shards shards(files);
    const report::Entries listed = shards.entries();
    const report::Scope scope{shards.excluded(), report::called_files(listed)};
    const report::Entries all = report::remove_called(listed, scope.called);
    const Reports reports(options, outputs, shards.programs() > 1);
    all([&](const report::Entry& entry) { reports.add(entry); });
    reports.write(all, scope);
    outputs.commit();
    return exit_code_of(all, options.exit_zero);
}

}  // namespace ncsim::app
