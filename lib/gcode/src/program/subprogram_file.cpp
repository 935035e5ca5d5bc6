// SPDX-License-Identifier: GPL-3.0-or-later
//
// File names of subprograms.
#include "ncsim/gcode/subprogram_file.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ncsim::gcode {
namespace {

constexpr std::array<std::string_view, 15> kEndings = {".ngc", ".nc",  ".NC",  ".tap", ".TAP",
                                                       ".cnc", ".CNC", ".txt", ".TXT", ".sub",
                                                       ".SUB", ".prg", ".PRG", ".mac", ""};

}  // namespace

bool is_program_file(std::string_view name) {
    return std::ranges::any_of(kEndings, [&](std::string_view ending) {
        return !ending.empty() && name.size() > ending.size() && name.ends_with(ending);
    });
}

std::vector<std::string> subprogram_files(std::string_view name) {
    std::vector<std::string> files;
    if (name.empty() || name.front() == '.' ||
        name.find_first_of(std::string_view("/\\\0", 3)) != std::string_view::npos) {
        return files;
    }
    std::vector<std::string> stems{std::string(name)};
    const std::string_view digits = name.substr(1);
    const bool is_number = name.front() == 'O' && !digits.empty() &&
                           digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_number) {
        // Fanuc uses four digits, Haas five; some post processors omit the O.
        for (const std::size_t width : {digits.size(), std::size_t{4}, std::size_t{5}}) {
            if (width < digits.size()) continue;
            const std::string padded =
                std::string(width - digits.size(), '0') + std::string(digits);
            for (const char* letter : {"O", "o", ""})
                stems.push_back(letter + padded);
        }
    }
    for (const std::string_view ending : kEndings) {
        for (const std::string& stem : stems) {
            std::string file = stem;
            file += ending;
            if (std::find(files.begin(), files.end(), file) == files.end()) {
                files.push_back(std::move(file));
            }
        }
    }
    return files;
}

}  // namespace ncsim::gcode
