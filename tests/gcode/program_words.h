// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of tests/programs by lines, and the places of numbers in them, for tests that rewrite
// them.
#pragma once

#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/interpreter.h"

#include "gcode/stage_programs.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::gcode::program_words {

using stage_programs::interpreter_options;
using stage_programs::kPrograms;
using stage_programs::program_of;

enum class Language { Iso, Klartext, Sinumerik };

struct Program {
    std::string name;
    Language language = Language::Iso;
    std::vector<std::string> lines;
    InterpreterOptions options;
};

inline std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

inline Program read(const std::string& folder) {
    const SourceFile file = program_of(kPrograms / folder);
    Program program;
    program.name = file.name;
    program.lines = lines_of(file.text);
    program.options = interpreter_options(kPrograms / folder, file);
    program.options.limits.repeated_blocks = 5000;
    program.language = file.name.ends_with(".h")     ? Language::Klartext
                       : file.name.ends_with(".mpf") ? Language::Sinumerik
                                                     : Language::Iso;
    const DialectFindings found = detect_dialect(file);
    if (program.language == Language::Iso && program.options.dialect == Dialect::Auto)
        program.options.dialect = found.dialect;
    return program;
}

/// Returns the length of the line without its comment.
inline std::size_t code_length(const Program& program, const std::string& line) {
    const std::size_t end = line.find_first_of(program.language == Language::Iso ? "(;" : ";");
    return end == std::string::npos ? line.size() : end;
}

inline bool is_blank(const Program& program, const std::string& line) {
    return line.find_first_not_of(" \t0123456789") >= code_length(program, line);
}

/// True if the line goes on in the next line.
inline bool goes_on(const std::string& line) {
    return line.ends_with('~');
}

/// True for the lines of Klartext that only set Q: they may belong to a cycle.
inline bool sets_parameters(const Program& program, const std::string& line) {
    const std::size_t code = line.find_first_not_of("0123456789 ");
    return program.language == Language::Klartext && code != std::string::npos && line[code] == 'Q';
}

/// True for lines with names, texts, words of the file or definitions of the tool and the stock.
inline bool is_special(const std::string& line) {
    for (const char* word : {"PGM", "BLK FORM", "TOOL", "%", "<", "\"", "MSG", "PROC", "DEF INT",
                             "DEF REAL", "CYCL DEF 12", "CYCL DEF 14"}) {
        if (line.find(word) != std::string::npos) return true;
    }
    return !line.empty() && (line[0] == 'O' || line[0] == 'o');
}

/// A number of a line: the letters in front of it, and its place.
struct Place {
    std::string name;
    std::size_t begin, end;
    bool has_equals;
};

inline bool is_number(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
}

inline bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Returns the numbers behind letters ("X-1.5", "Q200=2", "CR=5") and in lists ("(10,0,2").
inline std::vector<Place> numbers_of(const Program& program, const std::string& line) {
    std::vector<Place> places;
    const std::size_t size = code_length(program, line);
    const bool has_lists = program.language == Language::Sinumerik;
    int depth = 0;
    for (std::size_t i = 0; i < size;) {
        if (line[i] == '(') ++depth;
        if (line[i] == ')') --depth;
        const bool is_item = has_lists && depth == 1 && (line[i] == '(' || line[i] == ',');
        std::size_t at = i;
        std::string name;
        bool has_equals = false;
        if (is_letter(line[i])) {
            while (at < size && is_letter(line[at]))
                name += line[at++];
            std::size_t behind = at;
            while (behind < size && std::isdigit(static_cast<unsigned char>(line[behind])) != 0)
                ++behind;
            if (behind < size && line[behind] == '=') {
                name += line.substr(at, behind - at);
                at = behind + 1;
                has_equals = true;
            }
        } else if (is_item) {
            ++at;
        } else {
            ++i;
            continue;
        }
        std::size_t end = at;
        if (end < size && (line[end] == '+' || line[end] == '-')) ++end;
        const std::size_t digits = end;
        while (end < size && is_number(line[end]))
            ++end;
        const bool is_whole = !is_item || end >= size || line[end] == ',' || line[end] == ')';
        if (end > digits && is_whole) places.push_back({name, at, end, has_equals || is_item});
        i = std::max(end, at);
    }
    return places;
}

/// True for words whose value is a length, an angle or a feed.
inline bool is_value(const Program& program, const Place& place) {
    if (program.language == Language::Sinumerik && place.has_equals)
        return place.name[0] != 'R' || place.name == "RND" || place.name == "RP" ||
               place.name == "RPL";
    if (program.language == Language::Klartext && place.has_equals) return place.name[0] == 'Q';
    static const std::vector<std::string> kNames{"X",   "Y",   "Z",   "I",  "J",  "K",
                                                 "F",   "IX",  "IY",  "IZ", "PR", "PA",
                                                 "IPA", "IPR", "LEN", "CCA"};
    if (std::ranges::find(kNames, place.name) != kNames.end()) return true;
    return place.name == "R" && program.language == Language::Iso;
}

}  // namespace ncsim::gcode::program_words
