// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/program_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ncsim::nightly {
namespace {

TEST(RandomProgram, IsTheSameForTheSameSeed) {
    const Program a = random_program(7);
    const Program b = random_program(7);
    EXPECT_EQ(a.text, b.text);
    EXPECT_EQ(a.arguments, b.arguments);
    EXPECT_NE(a.text, random_program(8).text);
}

TEST(RandomProgram, LeavesNothingOut) {
    std::string all;
    int turning = 0;
    int probes = 0;
    double smallest = 1e9;
    double largest = 0.0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const Program program = random_program(seed);
        all += program.text;
        for (const std::string& argument : program.arguments)
            all += argument + "\n";
        for (const Move& move : program.moves)
            turning += move.course.turns() ? 1 : 0;
        probes += program.probes.empty() ? 0 : 1;
        const double size = norm(program.stock.max - program.stock.min);
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    for (const char* word :
         {"G20",     "G21",       "G90",    "G91\n",  "G90.1",  "G91.1", "G92",       "G17",
          "G18",     "G19",       "G0 ",    "G1 ",    "G2 ",    "G3 ",   " R",        " I",
          " J",      " K",        " P2",    " P3",    "G81",    "G82",   "G83",       "G73",
          "G85",     "G86",       "G89",    "G98",    "G99",    " L2",   " A",        " B",
          " C",      "=flat:",    "=ball:", "=bull:", "=face:", "=v:",   "=chamfer:", "=drill:",
          "=taper:", "--stock=D", "T3 M6"}) {
        EXPECT_NE(all.find(word), std::string::npos) << word;
    }
    EXPECT_GT(turning, 50);
    EXPECT_GT(probes, 50);
    EXPECT_LT(smallest, 0.1);
    EXPECT_GT(largest, 1000);
}

TEST(RandomProgram, NamesTheLineOfEachMove) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Program program = random_program(seed);
        const auto lines = std::count(program.text.begin(), program.text.end(), '\n');
        for (const Move& move : program.moves) {
            EXPECT_GT(move.line, 5U);
            EXPECT_LT(move.line, lines);
        }
    }
}

}  // namespace
}  // namespace ncsim::nightly
