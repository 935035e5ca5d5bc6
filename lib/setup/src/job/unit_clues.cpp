// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of inches in tool comments, feeds and coordinates.
#include "job/unit_clues.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/parser.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace ncsim::setup {

namespace {

// True if `text` has `unit` after a digit and at most a blank, as in 6MM and 6 mm.
bool has_unit(std::string_view text, std::string_view unit) {
    for (std::size_t at = text.find(unit); at != std::string_view::npos;
         at = text.find(unit, at + 1)) {
        std::size_t before = at;
        if (before > 0 && text[before - 1] == ' ') --before;
        const std::size_t behind = at + unit.size();
        const bool ends =
            behind == text.size() || std::isalnum(static_cast<unsigned char>(text[behind])) == 0;
        if (before > 0 && (is_digit(text[before - 1]) || text[before - 1] == '.') && ends)
            return true;
    }
    return false;
}

// True for 1/2, but not for dates and similar rows of numbers.
bool has_fraction(std::string_view text) {
    for (std::size_t at = text.find('/'); at != std::string_view::npos;
         at = text.find('/', at + 1)) {
        if (at == 0 || at + 1 == text.size()) continue;
        if (!is_digit(text[at - 1]) || !is_digit(text[at + 1])) continue;
        const std::string_view rest = text.substr(at + 1);
        const std::size_t end = rest.find_first_not_of("0123456789");
        const int denominator =
            std::stoi(std::string(rest.substr(0, std::min<std::size_t>(3, end))));
        const bool is_power =
            denominator > 1 && denominator <= 64 && (denominator & (denominator - 1)) == 0;
        if (is_power && (end == std::string_view::npos || rest[end] != '/')) return true;
    }
    return false;
}

bool is_in_inches(std::string_view text) {
    return has_fraction(text) || has_unit(text, "\"") || has_unit(text, "IN") ||
           has_unit(text, "INCH") || has_unit(text, "INCHES");
}

}  // namespace

bool suggests_inches(const gcode::SourceFile& program,
                     std::span<const toolpath::ToolEntry> tools_of_comments) {
    constexpr double kLargestFeed = 150.0;  // inches per minute
    constexpr double kLargestPlace = 60.0;  // inches
    constexpr double kLargestDepth = 4.0;   // inches
    bool is_any_in_inches = false;
    for (const toolpath::ToolEntry& tool : tools_of_comments) {
        const std::string text = uppercase(tool.text);
        if (has_unit(text, "MM")) return false;
        is_any_in_inches |= is_in_inches(text);
    }
    if (!is_any_in_inches || gcode::language_of(program) != gcode::Language::GCode) return false;
    gcode::BlockReader reader(program);
    gcode::Block block;
    while (reader.next(block)) {
        for (const gcode::Word& word : block.words) {
            if (!word.literal) continue;
            const double size = std::abs(word.number);
            const bool is_unit =
                word.letter == 'G' && (word.number == 20.0 || word.number == 21.0 ||
                                       word.number == 70.0 || word.number == 71.0);
            if (is_unit || (word.letter == 'F' && size > kLargestFeed)) return false;
            if (word.letter >= 'X' && word.letter <= 'Z' && size > kLargestPlace) return false;
            if (word.letter == 'Z' && word.number < -kLargestDepth) return false;
        }
    }
    return true;
}

}  // namespace ncsim::setup
