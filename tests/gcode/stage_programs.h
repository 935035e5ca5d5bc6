// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of tests/programs, with the options that concern the interpreter.
#pragma once

#include "ncsim/gcode/interpreter.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::stage_programs {

namespace fs = std::filesystem;

inline const fs::path kPrograms = fs::path(NCSIM_SOURCE_DIR) / "tests/programs";

inline std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline SourceFile program_of(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().stem() == "program")
            return {entry.path().filename().string(), read_file(entry.path())};
    }
    return {};
}

/// Options that concern the interpreter, by name.
inline std::map<std::string, std::string> options_of(const fs::path& folder) {
    std::istringstream in(read_file(folder / "options"));
    std::map<std::string, std::string> options;
    std::string name, value;
    while (std::getline(in, name) && std::getline(in, value))
        options[name] = value;
    return options;
}

inline InterpreterOptions interpreter_options(const fs::path& folder, const SourceFile& program) {
    InterpreterOptions options;
    // ncsim assumes the zero of the machine 300 mm above the origins of unspecified systems.
    for (Position& origin : options.work_offsets)
        origin.z = Length::from_mm(-300.0);
    const auto named = options_of(folder);
    if (const auto start = named.find("--start"); start != named.end()) {
        std::array<double, 3> at{};
        char comma = 0;
        std::istringstream(start->second) >> at[0] >> comma >> at[1] >> comma >> at[2];
        options.start = {Length::from_mm(at[0]), Length::from_mm(at[1]), Length::from_mm(at[2])};
    }
    if (const auto dialect = named.find("--dialect"); dialect != named.end()) {
        for (const Dialect one : {Dialect::Rs274, Dialect::Fanuc, Dialect::Haas}) {
            if (name_of(one) == dialect->second) options.dialect = one;
        }
    }
    options.block_delete = named.contains("--block-delete");
    // Diameters of tools that cycles and compensation need, from options or comments.
    const std::regex tool(R"(T(\d+)(?:=[a-z-]+:| )D=?([0-9.]+))");
    const std::string text =
        program.text + (named.contains("--tool") ? named.at("--tool") : std::string());
    for (auto at = std::sregex_iterator(text.begin(), text.end(), tool);
         at != std::sregex_iterator(); ++at) {
        options.tools.push_back({.number = std::stoi((*at)[1]),
                                 .offset = {},
                                 .length_specified = false,
                                 .diameter = Length::from_mm(std::stod((*at)[2]))});
    }
    options.read_file = [folder](std::string_view name) -> std::optional<SourceFile> {
        const fs::path path = folder / name;
        if (!fs::is_regular_file(path)) return std::nullopt;
        return SourceFile{path.filename().string(), read_file(path)};
    };
    return options;
}

inline std::vector<std::string> folders() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kPrograms)) {
        if (entry.is_directory() && fs::exists(entry.path() / "motions.txt"))
            names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace ncsim::gcode::stage_programs
