// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranges that messages name (cycle_limits.txt): the limits are accepted, values just beyond are
// refused, and each range in a message of lib/gcode is in the table.
#include "ncsim/gcode/interpreter.h"

#include "gcode/stage_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::cycle_limits_test {
namespace {

const std::filesystem::path kSource = NCSIM_SOURCE_DIR;

/// A line of the table.
struct Limits {
    std::string block;
    std::vector<std::string> accepted, refused;
    std::string message;
};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

std::vector<Limits> table() {
    std::ifstream in(kSource / "tests/gcode/cycle_limits.txt");
    std::vector<Limits> all;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> parts(1);
        for (const char c : line) {
            if (c == '|') {
                parts.emplace_back();
            } else {
                parts.back() += c;
            }
        }
        if (parts.size() != 4) {
            ADD_FAILURE() << line;
            continue;
        }
        all.push_back({parts[0].substr(0, parts[0].size() - 1), words_of(parts[1]),
                       words_of(parts[2]), parts[3].substr(1)});
    }
    return all;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// Returns the messages of a program with `block`, in the language of the block.
std::string messages_of(const std::string& block) {
    InterpreterOptions options;
    options.tools = {
        {.number = 1, .offset = {}, .length_specified = false, .diameter = Length::from_mm(10.0)}};
    options.compensation[2] = Length::from_mm(0.1);
    options.work_offsets_specified.fill(true);
    options.read_file = [](std::string_view) {
        return std::optional(SourceFile{"CONTOUR.SPF", "G1 X0 Y0\nX20\nY20\nM17\n"});
    };
    SourceFile program;
    if (block.starts_with("CYCL ")) {
        program = {
            "test.h",
            "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+3 Y+4 Z+60 R0 FMAX M3\nL F77\nCYCL DEF "
            "200 Q200=2 Q201=-1 Q206=9 Q202=9 Q203=0 Q204=50\n" +
                block + "\nL X+3 Y+4 FMAX M99\nM30\nEND PGM T MM\n"};
    } else if (block.find('(') != std::string::npos || block.starts_with("G3 ")) {
        options.dialect = Dialect::Sinumerik;
        program = {"test.mpf", "G710 G90 G17 G40 G94\nT1 M6\nS1000 D1\nG0 X3 Y4 Z60 M3\nF77\n" +
                                   block + "\nM30\n"};
    } else {
        const bool is_strict = block[0] == 'M' || block.starts_with("G10 ");
        options.strict = is_strict;
        options.dialect = is_strict ? Dialect::Rs274 : Dialect::Haas;
        // The value of a word has no '='.
        std::string words = block;
        std::erase(words, '=');
        std::ranges::replace(words, ';', '\n');
        program = {"test.nc",
                   "%\n" + std::string(is_strict ? "" : "O0001\n") +
                       "G21 G90 G17 G40 G80\nT1 M6\nS1000 G0 X0 Y0 Z60 M3\nF77\n" + words +
                       "\nG80 G40\nM30\n" +
                       (is_strict ? "" : "N77 G1 X5. Y0.\nY5.\nX-5.\nY-5.\nX5.\nY0.\nM99\n") +
                       "%\n"};
    }
    std::string messages;
    const Interpretation result = interpret(program, options, {});
    for (const Diagnostic& d : result.diagnostics)
        messages += d.message + '\n';
    return messages;
}

TEST(CycleLimits, AreTheLimitsOfTheMessage) {
    for (const Limits& limits : table()) {
        for (const std::string& value : limits.accepted) {
            const std::string block = replaced(limits.block, "{}", value);
            EXPECT_EQ(messages_of(block).find(limits.message), std::string::npos) << block;
        }
        EXPECT_FALSE(limits.refused.empty()) << limits.block;
        for (const std::string& value : limits.refused) {
            const std::string block = replaced(limits.block, "{}", value);
            const std::string messages = messages_of(block);
            EXPECT_NE(messages.find(limits.message), std::string::npos) << block << '\n'
                                                                        << messages;
        }
    }
}

/// Each accepted call is executed: without an error.
TEST(CycleLimits, AreReachedWithoutOtherFaults) {
    for (const Limits& limits : table()) {
        for (const std::string& value : limits.accepted) {
            const std::string block = replaced(limits.block, "{}", value);
            const std::string messages = messages_of(block);
            EXPECT_EQ(messages.find(" is stopped"), std::string::npos) << block << '\n' << messages;
        }
    }
}

TEST(CycleLimits, OfAllMessagesAreInTheTable) {
    const std::regex range(
        R"re("([^"\\\n]*(from -?[0-9.]+ to|between [0-9]|above 0|at least the|larger than|not below|whole, 1|of [0-9], [0-9] or|of [0-9] or [0-9]|from M[0-9])[^"\\\n]*)")re");
    const std::vector<Limits> all = table();
    std::size_t count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(kSource / "lib/gcode/src")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".def") continue;
        const std::string text = stage_programs::read_file(entry.path());
        for (auto at = std::sregex_iterator(text.begin(), text.end(), range);
             at != std::sregex_iterator(); ++at) {
            ++count;
            const std::string message = (*at)[1];
            EXPECT_TRUE(std::ranges::any_of(all,
                                            [&](const Limits& limits) {
                                                return message.find(limits.message) !=
                                                       std::string::npos;
                                            }))
                << entry.path().filename() << ": " << message;
        }
    }
    EXPECT_GT(count, 30U);
}

}  // namespace
}  // namespace ncsim::gcode::cycle_limits_test
