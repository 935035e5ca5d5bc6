// SPDX-License-Identifier: GPL-3.0-or-later
//
// Jumps and calls in files with several programs. The order of the subprograms, and line numbers in
// other programs, have no effect.
#include "ncsim/gcode/file_programs.h"
#include "ncsim/gcode/interpreter.h"

#include "gcode/outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
namespace {

using outcome::Outcome;
using outcome::run;

/// Programs with jumps: first the main program, then the subprograms in any order.
using Programs = std::vector<std::string>;

const std::vector<Programs>& all_programs() {
    static const std::vector<Programs> all = {
        // Loop by a jump back.
        {"O1\nG21 G90 G54 F100 S100 M3\n#1=0\nN10 #1=#1+1\nG1 X#1\nIF [#1 LT 3] GOTO 10\nM30\n"},
        // Jump forward, in front of a line with the same number before it.
        {"O1\nG21 G90 F100\nG1 X1\nGOTO 20\nN10 X9\nN20 X2\nIF [#5 EQ 1] GOTO 10\nM30\n"},
        // Loops in the main program and in two subprograms, all with N10.
        {"O1\nG21 G90 F100\n#1=0\nN10 #1=#1+1\nG1 X#1\nM98 P2\nIF [#1 LT 2] GOTO 10\nG65 P3 A1\n"
         "N20 G1 Y0\nM30\n",
         "O2\n#2=0\nN10 #2=#2+1\nG1 Y#2\nIF [#2 LT 2] GOTO 10\nN20 M99\n",
         "O3\nN10 #1=#1+1\nG1 Z#1\nIF [#1 LT 3] GOTO 10\nGOTO 20\nG1 Z99\nN20 M99\n"},
        // Return to a line of the program that called.
        {"O1\nG21 G90 F100\nM98 P2\nG1 X9\nN100 G1 X1\nM98 P4\nN200 X3\nM30\n",
         "O2\nG1 Y1\nM98 P3\nG1 Y9\nN100 G1 Y2\nM99 P100\n", "O3\nG1 Z1\nM99 P100\nN100 Z9\n",
         "O4\nN200 G1 Z2\nM99 P200\n"},
        // A number as an expression.
        {"O1\nG21 G90 F100\n#1=2\nGOTO [#1*10]\nN10 G1 X9\nN20 G1 X1\nM98 P2\nM30\n",
         "O2\nGOTO #1\nN1 G1 Y9\nN2 G1 Y1\nM99\n"},
    };
    return all;
}

/// Programs that no program calls, with the line numbers of the others.
const std::array<std::string, 3> kOthers = {
    "O71\nN1 G1 X91\nN10 X92\nN20 X93\nN100 X94\nN200 X95\nM99\n",
    "O72\nN200 G1 Z91\nN100 Z92\nGOTO 200\nN20 Z93\nN10 M99\n",
    "O73\nN2 #1=7\nN10 GOTO 20\nN20 G1 Y91\nM99\n"};

TEST(JumpTargets, AreLinesOfTheSameProgram) {
    std::mt19937 random(20261130);
    for (const Programs& programs : all_programs()) {
        std::string plain;
        for (const std::string& one : programs)
            plain += one;
        for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3}) {
            const Outcome expected = run(plain, dialect);
            EXPECT_EQ(expected.moves.find('9'), std::string::npos) << plain << expected.moves;
            EXPECT_FALSE(expected.says("line-not-found")) << plain;
            for (int i = 0; i < 20; ++i) {
                Programs subprograms(programs.begin() + 1, programs.end());
                std::ranges::copy_if(kOthers, std::back_inserter(subprograms),
                                     [&](const std::string&) { return random() % 2 == 0; });
                std::ranges::shuffle(subprograms, random);
                std::string text = programs.front();
                for (const std::string& one : subprograms)
                    text += one;
                EXPECT_EQ(run(text, dialect).moves, expected.moves) << text;
            }
        }
    }
}

TEST(JumpTargets, InOtherProgramsAreNotFound) {
    const std::string other = "O2\nN10 G1 X9\nM99\n";
    for (const std::string jump : {"GOTO 10", "IF [1 EQ 1] GOTO 10", "M97 P10", "M99 P10"}) {
        const Outcome outcome =
            run("O1\nG21 G90 F100\nG1 X1\n" + jump + "\nM30\n" + other, Dialect::Haas);
        EXPECT_TRUE(outcome.says("line-not-found")) << jump;
        EXPECT_EQ(outcome.moves.find('9'), std::string::npos) << jump;
    }
}

TEST(JumpTargets, LoopsEndInTheirProgram) {
    const std::string main = "O1\nG21 G90 F100\n#1=0\nWHILE [#1 LT 1] DO1\nG1 X1\n#1=1\n";
    const std::string other = "O2\nG1 X9\nEND1\nX9\nM99\n";
    EXPECT_TRUE(
        run(main + "M98 P2\nEND1\nM30\n" + other, Dialect::Fanuc).says("block-end-missing"));
    const Outcome open =
        run("O1\nG21 G90 F100\nWHILE [1 EQ 2] DO1\nX8\nM30\n" + other, Dialect::Fanuc);
    EXPECT_TRUE(open.says("block-end-missing"));
    EXPECT_EQ(open.moves, "");
}

/// M99 P in the main program continues in the line, unless the line is behind: then the program
/// starts again.
TEST(JumpTargets, M99WithPContinuesInTheMainProgram) {
    const std::string head = "O1\nG21 G90 F100\nN10 G1 X1\n";
    const Outcome forward = run(head + "M99 P20\nX9\nN20 X2\nM30\n", Dialect::Fanuc);
    EXPECT_EQ(forward.moves, "1 0 0 \n2 0 0 \n");
    EXPECT_FALSE(forward.says("main-repeats"));
    const Outcome back = run(head + "M99 P10\nX9\nM30\n", Dialect::Fanuc);
    EXPECT_EQ(back.moves, "1 0 0 \n");
    EXPECT_TRUE(back.says("main-repeats"));
}

TEST(Calls, WithTheNumberOfRunsInPAreCalls) {
    const std::string sub = "O0123\nG91 G1 X1\nG90\nM99\n";
    const std::string moves = "1 0 0 \n2 0 0 \n3 0 0 \n";
    for (const std::string call : {"M98 P123 L3", "M98 P30123", "M98 P030123", "M98 P00030123",
                                   "M98 P0123 L3", "/M98 P30123", "N5 M98P30123"}) {
        const std::string main = "G21 G90 F100\n" + call + "\nM30\n";
        EXPECT_EQ(run("O1\n" + main + sub, Dialect::Fanuc).moves, moves) << call;
        // The file has a single program, or two that call the same subprogram.
        const std::string one = "O1\n" + main + sub;
        const FilePrograms file(SourceFile{"a.nc", one});
        EXPECT_TRUE(file.unreached().empty()) << call;
        const std::string two = "O1\n" + main + "O2\n" + main + sub;
        const FilePrograms both(SourceFile{"a.nc", two});
        ASSERT_EQ(both.programs().size(), 2U) << call;
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_EQ(run(both.text_of(i, two), Dialect::Fanuc).moves, moves) << call;
    }
    // A program with the whole number comes first, and L is the number of runs.
    const std::string long_number = "O30123\nG1 X7\nM99\n";
    EXPECT_EQ(run("O1\nG90 F1\nM98 P30123\nM30\n" + sub + long_number, Dialect::Fanuc).moves,
              "7 0 0 \n");
    const std::string text = "O1\nM98 P30123\nM30\n" + sub + long_number;
    EXPECT_EQ(FilePrograms(SourceFile{"a.nc", text}).unreached().size(), 1U);
    // Two runs of a program that the control has.
    const Outcome of_control = run("O1\nG90 F1\nM98 P29010\nM30\n", Dialect::Fanuc);
    EXPECT_TRUE(of_control.says("macro-missing"));
    EXPECT_FALSE(of_control.says("program-not-found"));
}

}  // namespace
}  // namespace ncsim::gcode
