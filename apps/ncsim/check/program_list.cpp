// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the programs of a check.
#include "check/program_list.h"

#include "ncsim/report/shard.h"
#include "ncsim/setup/program_folder.h"

#include "check/pages.h"
#include "options/job_steps.h"
#include "system/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

/// True for the name of a verdict in a folder of --cache: the rest of a digest.
bool is_digest(const std::string& name) {
    return name.size() == 62 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Files that this run writes, and further runs with the same output folders.
class OutputFiles {
public:
    explicit OutputFiles(const CheckOptions& options)
        : files_(outputs_of(options)),
          shards_(whole(options.out)),
          verdicts_(whole(options.cache)),
          pages_(whole(page_folder(options.html))) {
        files_.push_back(page_file(options.html));
    }

    bool contains(const std::string& path) const {
        const fs::path file = whole(path);
        const fs::path folder = file.parent_path();
        if (folder == shards_ && file.extension() == ".ndjson") return true;
        if (folder == pages_ && (file.extension() == ".html" || file.extension() == ".png"))
            return true;
        if (folder.parent_path() == verdicts_ && is_digest(file.filename().string())) return true;
        return std::ranges::any_of(files_, [&](const std::string& output) {
            std::error_code error;
            return output != "-" && fs::equivalent(path, output, error) && !error;
        });
    }

private:
    static fs::path whole(const std::string& path) {
        std::error_code error;
        const fs::path result = path.empty() ? fs::path() : fs::weakly_canonical(path, error);
        return result.has_filename() ? result : result.parent_path();
    }

    std::vector<std::string> files_;
    fs::path shards_, verdicts_, pages_;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        if (line.ends_with('\r')) line.pop_back();
        if (!line.empty()) lines.push_back(std::move(line));
        at = end + 1;
    }
    return lines;
}

class Collector {
public:
    explicit Collector(const CheckOptions& options) : output_files_(options) {}

    void add_named(const std::string& name) {
        const std::size_t before = list_.programs.size();
        if (!add_folder(name)) return add(name, false);
        if (list_.programs.size() == before)
            throw std::runtime_error(fmt::format("there are no NC programs in '{}'", name));
    }
    void add_listed(const std::string& name) {
        const std::size_t before = list_.programs.size();
        if (add_folder(name)) {
            if (list_.programs.size() == before)
                list_.excluded.push_back({name, "folder without programs"});
            return;
        }
        if (auto why = name == "-" ? std::nullopt : setup::why_no_program(name)) {
            list_.excluded.push_back({name, std::move(*why)});
        } else {
            add(name, name != "-" && setup::is_subprogram_file(name));
        }
    }
    ProgramList take() && { return std::move(list_); }

private:
    bool add_folder(const std::string& name) {
        std::error_code ignored;
        if (!fs::is_directory(name, ignored)) return false;
        setup::ProgramFolder folder = setup::programs_in_folder(name);
        for (const std::string& program : folder.programs)
            add(program, setup::is_subprogram_file(program));
        for (report::ExcludedEntry& file : folder.excluded) {
            if (!output_files_.contains(file.path)) list_.excluded.push_back(std::move(file));
        }
        return true;
    }
    void add(const std::string& program, bool is_subprogram) {
        list_.programs.push_back(program);
        list_.is_subprogram.push_back(is_subprogram);
    }

    OutputFiles output_files_;
    ProgramList list_;
};

// Returns the chosen programs of the job, and notes their steps in `options`.
ProgramList programs_of_job(CheckOptions& options, setup::InputSet& inputs) {
    const std::vector<ChosenStep> steps = chosen_steps(options, inputs);
    std::error_code ignored;
    if (!fs::is_regular_file(options.job, ignored)) {
        (void)inputs.read(options.job, setup::kMostSetUpBytes);  // reports why it cannot be read
        throw std::runtime_error(
            fmt::format("'{}': the job of ncsim check is read several times: save it as a file",
                        setup::name_of_input(options.job)));
    }
    if (steps.empty()) throw std::runtime_error(fmt::format("'{}' names no program", options.job));
    ProgramList list;
    for (const ChosenStep& step : steps) {
        options.steps.push_back(step.number);
        list.programs.push_back(step.program);
        list.is_subprogram.push_back(false);
    }
    return list;
}

}  // namespace

ProgramList programs_of(CheckOptions& options, setup::InputSet& inputs) {
    if (options.programs.empty() && options.list.empty()) return programs_of_job(options, inputs);
    Collector collector(options);
    for (const std::string& name : options.programs)
        collector.add_named(name);
    if (!options.list.empty()) {
        for (const std::string& name : lines_of(inputs.read(options.list)))
            collector.add_listed(name);
    }
    ProgramList list = std::move(collector).take();
    if (!options.quiet) print_error(report::text_of(list.excluded));
    if (list.programs.empty()) throw std::runtime_error("the list names no programs");
    return list;
}

std::vector<std::size_t> share_of(const std::vector<std::string>& programs,
                                  const ShardNumber& number) {
    std::vector<std::uint64_t> sizes;
    for (const std::string& program : programs) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(program, error);
        sizes.push_back(error ? 0 : size);
    }
    return report::programs_of_shard(sizes, number.shard, number.of);
}

}  // namespace ncsim::app
