// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of tests/programs in other words: comments, blank lines, blanks, other spellings of
// numbers, values by variables, block delete, jumps, calls. The motions stay the same.
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include "gcode/stage_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::rewritten_programs_test {
namespace {

using namespace stage_programs;

enum class Language { Iso, Klartext, Sinumerik };

struct Program {
    std::string name;
    Language language = Language::Iso;
    std::vector<std::string> lines;
    InterpreterOptions options;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

Program read(const std::string& folder) {
    const SourceFile file = program_of(kPrograms / folder);
    Program program{.name = file.name, .lines = lines_of(file.text)};
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

/// Returns the motions without line numbers, and the codes of errors.
std::string motions_of(const Program& program, const std::vector<std::string>& lines) {
    std::string text, out;
    for (const std::string& line : lines)
        text += line + '\n';
    const Interpretation result =
        interpret({program.name, text}, program.options, [&](const Motion& motion) {
            std::string line;
            print(line, motion);
            out += line.substr(line.find(' ') + 1) + '\n';
        });
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::Error) out += "error " + std::string(d.code) + '\n';
    }
    return out;
}

using Rewrite = std::function<std::vector<std::string>(const Program&)>;

void expect_same_motions(const Rewrite& rewrite) {
    int count = 0;
    for (const std::string& folder : folders()) {
        const Program program = read(folder);
        const std::vector<std::string> lines = rewrite(program);
        if (lines == program.lines) continue;
        ++count;
        EXPECT_EQ(motions_of(program, lines), motions_of(program, program.lines)) << folder;
    }
    EXPECT_GT(count, 20);
}

/// Returns the length of the line without its comment.
std::size_t code_length(const Program& program, const std::string& line) {
    const std::size_t end = line.find_first_of(program.language == Language::Iso ? "(;" : ";");
    return end == std::string::npos ? line.size() : end;
}

bool is_blank(const Program& program, const std::string& line) {
    return line.find_first_not_of(" \t0123456789") >= code_length(program, line);
}

/// True if the line goes on in the next line.
bool goes_on(const std::string& line) {
    return line.ends_with('~');
}

/// True for the lines of Klartext that only set Q: they may belong to a cycle.
bool sets_parameters(const Program& program, const std::string& line) {
    const std::size_t code = line.find_first_not_of("0123456789 ");
    return program.language == Language::Klartext && code != std::string::npos && line[code] == 'Q';
}

/// True for lines with names, texts, words of the file or definitions of the tool and the stock.
bool is_special(const std::string& line) {
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

bool is_number(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Returns the numbers behind letters ("X-1.5", "Q200=2", "CR=5") and in lists ("(10,0,2").
std::vector<Place> numbers_of(const Program& program, const std::string& line) {
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
bool is_value(const Program& program, const Place& place) {
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

TEST(RewrittenPrograms, CommentsChangeNoMotion) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines = program.lines;
        for (std::string& line : lines) {
            if (is_blank(program, line) || is_special(line) || goes_on(line)) continue;
            line += program.language == Language::Iso ? " (X9. G1)" : " ; X9 G1";
        }
        return lines;
    });
}

TEST(RewrittenPrograms, BlankLinesAndBlanksChangeNoMotion) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines;
        for (const std::string& line : program.lines) {
            std::string wide;
            for (const char c : line)
                wide += c == ' ' ? std::string(" \t ") : std::string(1, c);
            lines.push_back(is_special(line) ? line : wide + " ");
            if (!goes_on(line) && !is_special(line)) lines.emplace_back();
        }
        return lines;
    });
}

TEST(RewrittenPrograms, SmallLettersWithoutBlanksAreTheSameWords) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines = program.lines;
        if (program.language != Language::Iso) return lines;
        for (std::string& line : lines) {
            const std::size_t size = code_length(program, line);
            if (is_special(line) || size < line.size()) continue;
            std::erase(line, ' ');
            std::ranges::transform(line, line.begin(), [](unsigned char c) {
                return static_cast<char>(std::tolower(c));
            });
        }
        return lines;
    });
}

TEST(RewrittenPrograms, SpellingsOfANumberAreTheSameValue) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines = program.lines;
        for (std::string& line : lines) {
            if (is_special(line)) continue;
            std::vector<Place> places = numbers_of(program, line);
            std::ranges::reverse(places);
            for (const Place& place : places) {
                if (!is_value(program, place)) continue;
                std::string number = line.substr(place.begin, place.end - place.begin);
                const bool has_sign = number[0] == '+' || number[0] == '-';
                const bool has_point = number.find('.') != std::string::npos;
                if (program.language != Language::Iso || has_point)
                    number += has_point ? "000" : ".0";
                number.insert(has_sign ? 1 : 0, "00");
                if (program.language == Language::Klartext) std::ranges::replace(number, '.', ',');
                line.replace(place.begin, place.end - place.begin, number);
            }
        }
        return lines;
    });
}

/// Each value is a variable that is set at the beginning of the program.
TEST(RewrittenPrograms, VariablesHaveTheEffectOfTheirValues) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines = program.lines;
        std::vector<std::string> values;
        for (std::string& line : lines) {
            if (is_special(line) || line.find('#') != std::string::npos) continue;
            std::vector<Place> places = numbers_of(program, line);
            std::ranges::reverse(places);
            for (const Place& place : places) {
                if (!is_value(program, place)) continue;
                const std::string number = line.substr(place.begin, place.end - place.begin);
                auto found = std::ranges::find(values, number);
                if (found == values.end()) found = values.insert(values.end(), number);
                const std::string index = std::to_string(500 + (found - values.begin()));
                const std::string variable = program.language == Language::Iso ? "#" + index
                                             : program.language == Language::Klartext
                                                 ? "+Q1" + index
                                             : place.has_equals ? "R" + index
                                                                : "=R" + index;
                line.replace(place.begin, place.end - place.begin, variable);
            }
        }
        std::vector<std::string> settings;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string index = std::to_string(500 + i);
            settings.push_back((program.language == Language::Iso        ? "#" + index
                                : program.language == Language::Klartext ? "Q1" + index
                                                                         : "R" + index) +
                               " = " + values[i]);
        }
        // Behind the comments, the name of the program and the definitions of Klartext.
        auto at = std::ranges::find_if(lines, [&](const std::string& line) {
            return line[0] == 'o' || (!is_special(line) && !is_blank(program, line));
        });
        lines.insert(at, settings.begin(), settings.end());
        return lines;
    });
}

std::string deletable(const Program& program, const std::string& line) {
    if (program.language != Language::Klartext) return "/" + line;
    const std::size_t code = line.find_first_not_of("0123456789 ");
    return line.substr(0, code) + "/ " + line.substr(code);
}

TEST(RewrittenPrograms, BlocksThatMayBeDeletedAreExecutedWithoutBlockDelete) {
    expect_same_motions([](const Program& program) {
        std::vector<std::string> lines = program.lines;
        if (program.options.block_delete) return lines;
        for (std::string& line : lines) {
            if (is_blank(program, line) || is_special(line) || sets_parameters(program, line))
                continue;
            line = deletable(program, line);
        }
        return lines;
    });
}

/// True for labels and loops, which other blocks need, and for a block that cannot be read.
bool is_needed(const std::string& line) {
    for (const char* word : {"LBL", "WHILE", "END", "DO", "X Y"}) {
        if (line.find(word) != std::string::npos) return true;
    }
    return false;
}

/// True if the effect of a block depends on the blocks behind it: blocks between are refused.
bool looks_ahead(const Program& program) {
    return std::ranges::any_of(program.lines, [](const std::string& line) {
        for (const char* word : {"APPR", "DEP", "RND", "CHF", "G150"}) {
            if (line.find(word) != std::string::npos) return true;
        }
        return false;
    });
}

TEST(RewrittenPrograms, ADeletedBlockIsAsABlankLine) {
    for (const std::string& folder : folders()) {
        Program program = read(folder);
        if (looks_ahead(program)) continue;
        program.options.block_delete = true;
        const std::size_t count = std::min<std::size_t>(program.lines.size(), 40);
        for (std::size_t i = 0; i < count; ++i) {
            const std::string& line = program.lines[i];
            if (is_blank(program, line) || is_special(line) || is_needed(line) || line[0] == '/' ||
                goes_on(line) || sets_parameters(program, line) ||
                (i > 0 && goes_on(program.lines[i - 1])))
                continue;
            std::vector<std::string> deleted = program.lines;
            std::vector<std::string> removed = program.lines;
            deleted[i] = deletable(program, line);
            removed[i].clear();
            EXPECT_EQ(motions_of(program, deleted), motions_of(program, removed))
                << folder << ": " << line;
        }
    }
}

/// Between all blocks are jumps over blocks, and conditions that are false.
TEST(RewrittenPrograms, SkippedBlocksChangeNoMotion) {
    expect_same_motions([](const Program& program) {
        if (looks_ahead(program)) return program.lines;
        std::vector<std::string> lines;
        const bool is_linuxcnc = program.options.dialect == Dialect::Rs274;
        int count = 9000;
        bool in_program = false;
        for (const std::string& line : program.lines) {
            in_program = in_program || (!is_special(line) && !is_blank(program, line));
            lines.push_back(line);
            const std::string label = std::to_string(++count);
            if (!in_program || goes_on(line) || is_special(line) || sets_parameters(program, line))
                continue;
            switch (program.language) {
                case Language::Iso:
                    if (is_linuxcnc) {
                        lines.push_back("o" + label + " if [1 EQ 2]");
                        lines.emplace_back("G1 X999.");
                        lines.push_back("o" + label + " endif");
                    } else {
                        lines.push_back("GOTO " + label);
                        lines.emplace_back("G1 X999.");
                        lines.push_back("N" + label);
                    }
                    break;
                case Language::Klartext:
                    lines.push_back("FN 9: IF +1 EQU +1 GOTO LBL " + label);
                    lines.emplace_back("L X+999 FMAX");
                    lines.push_back("LBL " + label);
                    break;
                case Language::Sinumerik:
                    lines.push_back("GOTOF L_" + label);
                    lines.emplace_back("G1 X999");
                    lines.push_back("L_" + label + ": IF 1==2");
                    lines.emplace_back("G1 X999");
                    lines.emplace_back("ENDIF");
                    break;
            }
        }
        return lines;
    });
}

}  // namespace
}  // namespace ncsim::gcode::rewritten_programs_test
