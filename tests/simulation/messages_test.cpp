// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages about a program before and during the simulation, word for word: each row of
// simulation_messages.def.
#include "support/messages.h"

#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include "simulation_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace ncsim::simulation {
namespace {

struct Case {
    const char* program;
    bool draft;
    const char* said;
};

constexpr Case kCases[] = {
    {"G21 G90\nG0 X0 Y0 Z1\nG1 Z-1 F100\nX9\nM2\n", false,
     "tool-unknown: no tool is called before this cut; for a first look: --assume-tool flat:D2, a "
     "guess from the moves"},
    {"G21 G90 T7 M6\nG0 X0 Y0 Z1\nG1 Z-1 F100\nX9\nM2\n", false,
     "tool-unknown: tool 7 is not described; say what it is with --tool T7=flat:D2 or in a comment "
     "such as (T7 D=10. CR=0. - flat end mill); for a first look: --assume-tool flat:D2, a guess "
     "from its moves"},
    {"(T1 D=6. CR=0. - flat end mill)\nG21 G90 T1 M6\nG0 X0 Y0 Z1\nT0 M6\nG1 Z-1 F100\nX9\nM2\n",
     false, "spindle-empty: T0 left the spindle empty before this cut: call a tool"},
    {"(T1 D=6. CR=4. - flat end mill)\nG21 G90 T1 M6\nG0 X0 Y0 Z1\nG1 Z-1 F100\nX9\nM2\n", false,
     "tool-conflict: tool 1: R4 of a ball end mill is not half of D6; it was made as ball end mill "
     "D6 L30"},
    {"(T1 D=6. CR=0. - flat end mill)\nG21 G90 T1 M6\nG0 X0 Z1\nG1 Z-1 F100\nX9\nM2\n", false,
     "axis-unknown: the program never sets Y; taken as 0 (--start)"},
    {"G21 G90\nG0 X0 Y0\nG1 X9 F100\nM2\n", true,
     "axis-unknown: the program never sets Z; taken as 0 (--start), and the program is drawn as a "
     "path"},
    {"G21 G90\nM2\n", false, "no-motion: the program makes no move"},
    {"G21 G90\nG0 X1 Y1 Z1\nX2\nM2\n", false,
     "no-motion: the program makes no cutting move, only rapid ones; for a picture of its path: "
     "--draft"},
    {"G21 G90\nG0 X1 Y1 Z1\nX2\nM2\n", true,
     "no-motion: the program makes no cutting move, only rapid ones; it is drawn as a path"},
    {"(T1 D=6. CR=0. - flat end mill)\nG21 G90 T1 M6\nG1 X9 Y9 Z-1 F100\nM2\n", false,
     "no-motion: no cutting move starts at a known position"},
    {"(T1 D=6. CR=0. - flat end mill)\nG21 G90 T1 M6\nG1 X9 Y9 Z-1 F100\nX20\nM2\n", false,
     "start-unknown: this cutting move starts at an unknown position; it cuts nothing"},
    {"(T1 D=6. CR=0. - flat end mill)\nG21 G90 T1 M6\nG0 X0 Y0 Z1\nG1 Z-1 F100\nX900000\nM2\n",
     false,
     "stock-size: the stock would reach from -45004 to 945004 mm: is a unit wrong, or a number? "
     "Say "
     "what the block is with --stock"},
    {"(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\nG21 G90 T1 M6\n"
     "G0 X0 Y0 Z5\nG1 Z-1 F100\nG2 X0 Y0 I10 P200000\nM2\n",
     false,
     "path-accuracy: this move takes more steps than are made of one: its path is missed by up to "
     "197 mm, more than --tolerance 0.005"},
};

std::vector<std::string> said_of(const Case& c) {
    Plan plan;
    plan.job = setup::job_of({"t.nc", c.program}, {});
    plan.draft = c.draft;
    std::vector<std::string> said;
    const Survey found = survey(plan);
    for (const gcode::Diagnostic& d : found.diagnostics)
        said.push_back(test::said(d));
    if (!found.is_ready() || gcode::has_errors(found.diagnostics)) return said;
    for (const gcode::Diagnostic& d : simulate(plan).diagnostics)
        said.push_back(test::said(d));
    return said;
}

TEST(Messages, AreSaidInTheseWords) {
    for (const Case& c : kCases) {
        const std::vector<std::string> said = said_of(c);
        std::string all;
        for (const std::string& s : said)
            all += s + "\n";
        EXPECT_TRUE(std::ranges::find(said, c.said) != said.end())
            << c.program << c.said << "\nis not in\n"
            << all;
    }
}

TEST(Messages, AreAllSaidHere) {
    constexpr gcode::MessageText kRows[] = {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) Message::name,
#include "simulation_messages.def"
#undef NCSIM_DIAGNOSTIC
    };
    for (const gcode::MessageText& row : kRows) {
        EXPECT_TRUE(std::ranges::any_of(kCases, [&](const Case& c) {
            return test::says(c.said, row);
        })) << row.text;
    }
}

}  // namespace
}  // namespace ncsim::simulation
