// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of tests/programs in other words: comments, blank lines, blanks, other spellings of
// numbers, values by variables, block delete, jumps, calls. The motions stay the same.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include "gcode/program_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::rewritten_programs_test {
namespace {

using namespace program_words;
using stage_programs::folders;

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

/// True for labels and loops, which other blocks need.
bool is_needed(const std::string& line) {
    for (const char* word : {"LBL", "WHILE", "END", "DO"}) {
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

/// Returns "N100" of "N100 G0 X1": a deleted block may be the target of a jump.
std::string block_number(const std::string& line) {
    return line[0] == 'N' ? line.substr(0, line.find_first_not_of("0123456789", 1)) : std::string();
}

TEST(RewrittenPrograms, ADeletedBlockIsAsABlankLine) {
    for (const std::string& folder : folders()) {
        Program program = read(folder);
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
            removed[i] = block_number(line);
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
