// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge.h"

#include "ncsim/report/shard.h"

#include "output.h"
#include "reports.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

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
            if (entry->path().extension() == ".ndjson") files.push_back(entry->path().string());
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
        "merge", "Put results of ncsim check --shard together: the reports of one run");
    merge->add_option("sources", o.sources, "Folders of results, or the files")
        ->required()
        ->type_name("DIRS");
    add_report_options(*merge, o);
    return merge;
}

int run(MergeOptions options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    const std::vector<std::string> files = files_of(options.sources);
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
