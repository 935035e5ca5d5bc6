// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of data between G10 L50 and G11 of Fanuc: whatever they contain, they move nothing, and
// every parameter that may change the program is reported.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Outcome {
    std::string moves;
    Diagnostics diagnostics;
    std::ptrdiff_t count(std::string_view code) const {
        return std::ranges::count(diagnostics, code, &Diagnostic::code);
    }
};

Outcome run(const std::string& text, Dialect dialect = Dialect::Fanuc,
            std::vector<std::string> allow = {}) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.allow = std::move(allow);
    Outcome outcome;
    outcome.diagnostics = interpret({"a.nc", text}, options, [&](const Motion& motion) {
                              print(outcome.moves, motion);
                              outcome.moves += '\n';
                          }).diagnostics;
    return outcome;
}

const std::string kHead = "O1\nG21 G90 G17 G54 F100 S100 T1 M6 M3\nG0 X0 Y0 Z5\n";
const std::string kTail = "G1 X10\nG81 X20 Z-1 R1\nG80\nM30\n";

/// Replaces lines that are left out by empty lines, so that the others keep their numbers.
std::string blank_lines(std::size_t count) {
    return std::string(count, '\n');
}

TEST(DataLines, MoveNothing) {
    std::mt19937 random(20261130);
    const auto below = [&random](unsigned n) { return static_cast<int>(random() % n); };
    for (int round = 0; round < 60; ++round) {
        const bool tool_life = below(4) == 0;
        const int count = 1 + below(4);
        std::string data;
        for (int i = 0; i < count; ++i) {
            if (tool_life) {
                data += "T" + std::to_string(below(9)) + " H" + std::to_string(below(9)) + " D" +
                        std::to_string(below(9)) + "\n";
                continue;
            }
            data += "N" + std::to_string(1000 + below(9000));
            if (below(2) == 0) data += " P" + std::to_string(below(9));
            data += " R" + std::to_string(below(99)) + "\n";
        }
        const std::string open = tool_life ? "G10 L3\n" : below(2) == 0 ? "G10 L50\n" : "G10 L52\n";
        const Outcome with = run(kHead + open + data + "G11\n" + kTail);
        const Outcome without =
            run(kHead + blank_lines(static_cast<std::size_t>(count) + 2) + kTail);
        EXPECT_EQ(with.moves, without.moves) << data;
        EXPECT_FALSE(has_errors(with.diagnostics)) << data;
        EXPECT_EQ(with.count("word-unused"), 0) << data;
    }
}

TEST(DataLines, OfParametersThatMayChangeTheProgramAreReported) {
    // Zero of G54, backlash, rapid override; counter of parts, display.
    for (const std::string parameter : {"1221", "1851", "1420", "5114", "6000"})
        EXPECT_EQ(run(kHead + "G10 L50\nN" + parameter + " R1\nG11\n" + kTail).count("data-line"),
                  1);
    for (const std::string parameter : {"6711", "6712", "6713", "6757", "3111", "20"})
        EXPECT_EQ(run(kHead + "G10 L50\nN" + parameter + " R1\nG11\n" + kTail).count("data-line"),
                  0);
    const std::string two = kHead + "G10 L50\nN1221 P1 R1\nN5114 R1\nG11\n" + kTail;
    EXPECT_EQ(run(two).count("data-line"), 2);
    EXPECT_EQ(run(two, Dialect::Fanuc, {"N1221"}).count("data-line"), 1);
    EXPECT_EQ(run(two, Dialect::Fanuc, {"N1221", "N5114"}).count("data-line"), 0);
    EXPECT_EQ(run(kHead + "G10 L3\nP1 L50\nT1\nG11\n" + kTail).count("data-line"), 1);
}

TEST(DataLines, WithoutG11AreAFault) {
    for (const std::string block : {"G0 Z9", "X5", "M8", "S500", "G1 X5 F9"}) {
        const Outcome open = run(kHead + "G10 L50\nN6711 R0\n" + block + "\n" + kTail);
        EXPECT_EQ(open.count("data-lines-open"), 1) << block;
        const Outcome closed = run(kHead + "G10 L50\nN6711 R0\nG11\n" + block + "\n" + kTail);
        EXPECT_EQ(closed.count("data-lines-open"), 0) << block;
    }
}

TEST(DataLines, AreOfFanucAlone) {
    const std::string text = kHead + "G10 L50\nN6711 R0\nG11\n" + kTail;
    for (const Dialect dialect : {Dialect::Haas, Dialect::Mach3, Dialect::Grbl})
        EXPECT_EQ(run(text, dialect).count("g10-form"), 1) << name_of(dialect);
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Auto})
        EXPECT_EQ(run(text, dialect).count("g10-form"), 0) << name_of(dialect);
    InterpreterOptions strict;
    strict.strict = true;
    EXPECT_TRUE(has_errors(interpret({"a.nc", text}, strict, {}).diagnostics));
}

}  // namespace
}  // namespace ncsim::gcode
