// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/program_list.h"

#include "ncsim/gcode/subprogram_file.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/shard.h"

#include "system/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> programs_in(const std::string& folder) {
    std::vector<std::string> programs;
    std::size_t texts = 0;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored) ||
            !gcode::is_program_file(entry->path().filename().string()))
            continue;
        // Texts of all kinds are called so.
        if (entry->path().extension() == ".txt") {
            ++texts;
        } else {
            programs.push_back(entry->path().string());
        }
    }
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot read the folder '{}': {}", folder, error.message()));
    }
    if (programs.empty())
        throw std::runtime_error(fmt::format("there are no NC programs in '{}'", folder));
    if (texts > 0) {
        say(fmt::format("ncsim: {} .txt in '{}' left out: name those that are programs\n", texts,
                        report::one_line(folder)));
    }
    std::ranges::sort(programs);
    return programs;
}

}  // namespace

std::vector<std::string> programs_of(const CheckOptions& options, setup::InputSet& inputs) {
    std::vector<std::string> named = options.programs;
    if (!options.list.empty()) {
        const std::string text = inputs.read(options.list);
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            std::string line = text.substr(at, end - at);
            if (line.ends_with('\r')) line.pop_back();
            if (!line.empty()) named.push_back(std::move(line));
            at = end + 1;
        }
    }
    std::vector<std::string> programs;
    for (std::string& name : named) {
        std::error_code ignored;
        if (fs::is_directory(name, ignored)) {
            const std::vector<std::string> inside = programs_in(name);
            programs.insert(programs.end(), inside.begin(), inside.end());
        } else {
            programs.push_back(std::move(name));
        }
    }
    if (programs.empty()) throw std::runtime_error("the list names no programs");
    return programs;
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
