// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge.h"

#include "ncsim/report/shard.h"

#include "output.h"
#include "reports.h"
#include "tiles.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kTile = ".nctile";

// The results in folders, and files that are named.
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

CLI::App* add_merge(CLI::App& app, MergeOptions& o) {
    CLI::App* merge = app.add_subcommand(
        "merge",
        "Put results of ncsim check --shard or ncsim run --tile together: what one run writes");
    merge->add_option("sources", o.sources, "Folders of results, or the files")
        ->required()
        ->type_name("DIRS");
    add_report_options(*merge, o);
    const auto of_run = [&](const char* name, const char* type, const char* what) {
        merge
            ->add_option_function<std::string>(
                std::string("--") + name,
                [&o, name](const std::string& value) { o.of_run.emplace_back(name, value); }, what)
            ->type_name(type);
    };
    of_run("gltf", "FILE", "Of tiles: mesh with the NC line of every face, glTF 2.0 binary");
    of_run("stl", "FILE", "Of tiles: mesh, binary STL");
    of_run("3mf", "FILE", "Of tiles: mesh with a material for each tool, 3MF");
    of_run("ply", "FILE", "Of tiles: mesh with the NC line of every face, PLY");
    of_run("vrml", "FILE", "Of tiles: mesh with the NC line of every face, VRML97");
    of_run("png", "FILE", "Of tiles: picture of the part");
    of_run("view", "VIEW", "Of the picture: iso, top, bottom, front, back, left, right");
    of_run("simplify", "TOL", "Of tiles: merge faces and edges in meshes within TOL mm");
    of_run("report", "FILE", "Of tiles: what happened, JSON");
    return merge;
}

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
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    for (const std::string& file : files)
        inputs.expect(file);
    for (const std::string& path : outputs_of(options))
        outputs.reserve(path);
    const report::Shards shards(files);
    const report::Entries all = shards.entries();
    const Reports reports(options, outputs, shards.programs() > 1);
    all([&](const report::Entry& entry) { reports.tell(entry); });
    reports.write(all);
    outputs.commit();
    return exit_code_of(all, options.exit_zero);
}

}  // namespace ncsim::app
