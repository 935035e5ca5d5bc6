// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/program_list.h"

#include "ncsim/report/shard.h"
#include "ncsim/setup/program_folder.h"

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

/// Files and folders that this run writes, and other runs like it.
class Written {
public:
    explicit Written(const CheckOptions& options) : files_(outputs_of(options)) {
        for (const std::string* folder : {&options.out, &options.cache}) {
            std::error_code error;
            if (!folder->empty()) folders_.push_back(fs::weakly_canonical(*folder, error));
        }
    }

    bool contains(const std::string& path) const {
        const auto is_same = [&](const std::string& file) {
            std::error_code error;
            return file != "-" && fs::equivalent(path, file, error) && !error;
        };
        std::error_code error;
        const fs::path whole = fs::weakly_canonical(path, error);
        const auto is_below = [&](const fs::path& folder) {
            return std::ranges::mismatch(folder, whole).in1 == folder.end();
        };
        return std::ranges::any_of(files_, is_same) || std::ranges::any_of(folders_, is_below);
    }

private:
    std::vector<std::string> files_;
    std::vector<fs::path> folders_;
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
    explicit Collector(const CheckOptions& options) : written_(options) {}

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
                list_.left_out.push_back({name, "folder without programs"});
            return;
        }
        if (auto why = name == "-" ? std::nullopt : setup::why_no_program(name)) {
            list_.left_out.push_back({name, std::move(*why)});
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
        for (report::LeftOut& file : folder.left_out) {
            if (!written_.contains(file.path)) list_.left_out.push_back(std::move(file));
        }
        return true;
    }
    void add(const std::string& program, bool is_subprogram) {
        list_.programs.push_back(program);
        list_.is_subprogram.push_back(is_subprogram);
    }

    Written written_;
    ProgramList list_;
};

}  // namespace

ProgramList programs_of(const CheckOptions& options, setup::InputSet& inputs) {
    Collector collector(options);
    for (const std::string& name : options.programs)
        collector.add_named(name);
    if (!options.list.empty()) {
        for (const std::string& name : lines_of(inputs.read(options.list)))
            collector.add_listed(name);
    }
    ProgramList list = std::move(collector).take();
    say(report::text_of(list.left_out));
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
    return report::dealt(sizes, number.shard, number.of);
}

}  // namespace ncsim::app
