// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of tests/programs with one damaged number: removed, zero, of the other sign, large, or
// not whole. A program that is said to be stopped is stopped, messages name places of the program,
// and motions have numbers.
#include "ncsim/gcode/interpreter.h"

#include "gcode/program_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace ncsim::gcode::damaged_programs_test {
namespace {

using namespace program_words;
using stage_programs::folders;

enum class Damage { Removed, Zero, OtherSign, Large, NotWhole };
constexpr std::size_t kDamages = 5;

std::string damaged(const std::string& line, const Place& place, Damage damage) {
    const std::string number = line.substr(place.begin, place.end - place.begin);
    const bool is_negative = number[0] == '-';
    const std::string digits = is_negative || number[0] == '+' ? number.substr(1) : number;
    std::size_t begin = place.begin;
    std::string text;
    switch (damage) {
        case Damage::Removed: begin -= place.has_equals ? 0 : place.name.size(); break;
        case Damage::Zero: text = "0"; break;
        case Damage::OtherSign: text = (is_negative ? "+" : "-") + digits; break;
        case Damage::Large: text = "98765432"; break;
        case Damage::NotWhole: text = "0.37"; break;
    }
    return line.substr(0, begin) + text + line.substr(place.end);
}

bool is_finite(const Position& p) {
    return std::isfinite(p.x.mm()) && std::isfinite(p.y.mm()) && std::isfinite(p.z.mm());
}

/// Interprets the lines; returns the messages that stop the program.
std::set<std::string> stops_of(const Program& program, const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + '\n';
    bool all_finite = true;
    const Interpretation result =
        interpret({program.name, text}, program.options, [&](const Motion& motion) {
            if (start_of(motion)) all_finite = all_finite && is_finite(*end_of(motion));
        });
    EXPECT_TRUE(all_finite);
    std::set<std::string> stops;
    for (const Diagnostic& d : result.diagnostics) {
        const bool is_in_program = d.span.line >= 1 && d.span.line <= lines.size();
        if (d.file.empty() && is_in_program) {
            const std::size_t size = lines[d.span.line - 1].size();
            EXPECT_GE(d.span.column, 1U) << d.message;
            EXPECT_LE(d.span.column, size + 1) << d.message;
        }
        if (d.message.find("the program is stopped here") == std::string::npos) continue;
        stops.insert(d.message);
        EXPECT_TRUE(result.refused || result.stopped) << d.message;
    }
    return stops;
}

TEST(DamagedPrograms, StopWhereTheirMessagesSaySo) {
    std::set<std::string> stops;
    std::size_t count = 0;
    for (const std::string& folder : folders()) {
        const Program program = read(folder);
        for (std::size_t i = 0; i < program.lines.size(); ++i) {
            for (const Place& place : numbers_of(program, program.lines[i])) {
                for (std::size_t damage = 0; damage < kDamages; ++damage, ++count) {
                    std::vector<std::string> lines = program.lines;
                    lines[i] = damaged(lines[i], place, static_cast<Damage>(damage));
                    SCOPED_TRACE(folder + ": " + lines[i]);
                    stops.merge(stops_of(program, lines));
                }
            }
        }
    }
    EXPECT_GT(count, 15'000U);
    EXPECT_GT(stops.size(), 30U);
}

}  // namespace
}  // namespace ncsim::gcode::damaged_programs_test
