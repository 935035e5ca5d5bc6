// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files with several programs: blocks at which a control can start, and blocks that are never
// reached.
#include "ncsim/gcode/file_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

FilePrograms read(const std::string& text) {
    return FilePrograms(SourceFile{"a.nc", text});
}

std::vector<std::string> labels(const std::string& text) {
    std::vector<std::string> labels;
    const FilePrograms file = read(text);
    for (const FileProgram& program : file.programs())
        labels.push_back(program.label);
    return labels;
}

using Labels = std::vector<std::string>;

TEST(FilePrograms, EndInM30AndAreCalledByNone) {
    const Labels one{"program 1"};
    EXPECT_EQ(labels(""), one);
    EXPECT_EQ(labels("G0 X1\nM30\n"), one);
    EXPECT_EQ(labels("%\nO1\nG0 X1\nM30\n%\n"), one);
    EXPECT_EQ(labels("O0100\nG1 X1\nM30\nO0101\nG1 X2\nM30\n"), (Labels{"O0100", "O0101"}));
    EXPECT_EQ(labels("%\n(HEAD)\nO1 (A)\nM2\nO2\nX1\nM02\n:3\nM30\n%\n"),
              (Labels{"O1", "O2", "O3"}));
    EXPECT_EQ(labels("%\nO1\nX1\nM30\n%\n\n%\nO2\nX1\nM30\n%\n"), (Labels{"O1", "O2"}));
    EXPECT_EQ(labels("%\nO1\nX1\n%\nO2\nX1\n%\n").front(), "O1");
    EXPECT_EQ(labels("G0 X1\nM30\nO2\nM30\n"), (Labels{"program 1", "O2"}));
    // Subprograms, called or uncalled, before or after the program.
    EXPECT_EQ(labels("O1\nM98 P2\nM30\nO2\nX1\nM99\n"), Labels{"O1"});
    EXPECT_EQ(labels("O1\nM98 P0002\nM30\nO2\nX1\nM30\n"), Labels{"O1"});
    EXPECT_EQ(labels("O1\nG65 P2\nM30\nO2\nX1\nM99\nO3\nM98P2\nM30\n"), (Labels{"O1", "O3"}));
    EXPECT_EQ(labels("O1\nX1\nM99\nO2\nX1\nM30\n"), (Labels{"O1", "O2"}));
    // A program without an end continues into the next program.
    EXPECT_EQ(labels("O1\nX1\nO2\nX2\nM30\n"), Labels{"O1"});
    EXPECT_EQ(labels("O1\nIF [#1 EQ 1] THEN M30\nO2\nX2\nM30\n"), Labels{"O1"});
    // Labels of LinuxCNC are not program numbers.
    EXPECT_EQ(labels("o100 sub\nG0 X1\no100 endsub\no100 call\nM2\n"), one);
}

std::vector<std::string> unreached(const std::string& text) {
    std::vector<std::string> parts;
    const FilePrograms file = read(text);
    for (const Unreached& part : file.unreached())
        parts.push_back(part.label + std::to_string(part.span.line));
    return parts;
}

TEST(FilePrograms, NameMovesBehindAnEnd) {
    EXPECT_EQ(unreached("G0 X1\nM30\nG0 X2\n"), Labels{"3"});
    EXPECT_EQ(unreached("%\nG0 X1\n%\nG0 X2\nG0 X3\n"), Labels{"4"});
    EXPECT_EQ(unreached("G0 X1\nM99\nG0 X2\n").size(), 0U) << "one look finds no end: M99";
    EXPECT_EQ(unreached("O1\nX1\nM30\nX2\nO2\nX1\nM2\nY5\n"), (Labels{"4", "8"}));
    EXPECT_EQ(unreached("O1\nX1\nM30\nO200\nX1\nM99\n"), Labels{"O2005"});
    for (const char* good :
         {"G0 X1\nM30\n%\nsent at noon\n", "G0 X1\nM30\n(G0 X2)\n", "G0 X1\nM30\nM30\n",
          "IF [#1 EQ 1] GOTO 10\nM30\nN10 G0 X2\nM30\n", "GOTO #1\nM30\nN10 G0 X2\nM30\n",
          "M97 P10\nM30\nN10 G0 X2\nM99\n", "o1 if [#1]\nM2\no1 endif\nG0 X1\nM2\n",
          "M2\no<a> sub\nG0 X1\no<a> endsub\n", "O1\nM98 P2\nM30\nO2\nX1\nM99\n",
          "O1\nM98 P#1\nM30\nO2\nX1\nM99\n", "O1\nM30\nO2\n#1=5\nM99\n",
          "IF [#1 EQ 1] THEN M30\nG0 X1\nM30\n"})
        EXPECT_TRUE(unreached(good).empty()) << good;
    EXPECT_EQ(unreached("G0 X1\n/M30\nG0 X2\nM30\n"), Labels{"3"});
}

// A line behind the end is reached only if a block that is reached names it, in the same program.
TEST(FilePrograms, TargetsCountOnlyFromBlocksThatAreReached) {
    const std::string dead = "N10 G1 X2\n";
    EXPECT_EQ(unreached("O1\nX1\nM30\n" + dead + "GOTO 10\n"), Labels{"4"});
    EXPECT_EQ(unreached("O1\nX1\nM30\n" + dead + "M97 P10\nM99\n"), Labels{"4"});
    EXPECT_EQ(unreached("O1\nX1\nM30\n" + dead + "M99\nO2\nGOTO 10\nN10 X3\nM30\n"), Labels{"4"});
    EXPECT_EQ(unreached("O1\nX1\nM30\n" + dead + "M99\nO2\nM97 P10\nM30\nN10 X3\nM99\n"),
              Labels{"4"});
    EXPECT_EQ(unreached("O1\nX1\nM30\n" + dead + "GOTO #1\n"), Labels{"4"});
    for (const std::string jump : {"GOTO 10", "IF [#1 EQ 1] GOTO 10", "M97 P10", "GOTO #1"})
        EXPECT_TRUE(unreached("O1\nX1\n" + jump + "\nM30\n" + dead + "M99\n").empty()) << jump;
    // A subprogram returns to a line of the program that calls it.
    EXPECT_TRUE(unreached("O1\nM98 P2\nM30\n" + dead + "M30\nO2\nX3\nM99 P10\n").empty());
    // Chains of jumps of any length, in both directions.
    for (int length = 1; length < 30; ++length) {
        std::string forward = "O1\nIF [#1 EQ 1] GOTO 1\nM30\n";
        std::string backward = "O1\nIF [#1 EQ 1] GOTO 1\nM30\n";
        for (int i = 1; i <= length; ++i) {
            const std::string next = std::to_string(i + 1);
            forward += "N" + std::to_string(i) + " X1\nIF [#1 EQ 1] GOTO " + next + "\nM30\n";
            const int from = length + 1 - i;
            backward += "N" + std::to_string(from) + " X1\nIF [#1 EQ 1] GOTO " +
                        std::to_string(from + 1) + "\nM30\n";
        }
        EXPECT_TRUE(unreached(forward).empty()) << forward;
        EXPECT_TRUE(unreached(backward).empty()) << backward;
    }
}

TEST(FilePrograms, AreReadWithEmptyLinesForTheOthers) {
    const std::string text = "%\n(HEAD)\nO1\nM98 P9\r\nM30\nO2\nX2\nM30\nO9\nX9\nM99\n%\n";
    const FilePrograms file = read(text);
    ASSERT_EQ(file.programs().size(), 2U);
    EXPECT_EQ(file.text_of(0, text), "%\n(HEAD)\nO1\nM98 P9\r\nM30\n\n\n\nO9\nX9\nM99\n%\n");
    EXPECT_EQ(file.text_of(1, text), "%\n(HEAD)\n\n\r\n\nO2\nX2\nM30\nO9\nX9\nM99\n%\n");
    // A program that a second program calls stays in the text.
    const std::string calls = "O1\nX1\nM30\nO2\nM98 P1\nM30\n";
    EXPECT_EQ(read(calls).text_of(1, calls), calls);
}

// For any bytes, lines keep their numbers.
TEST(FilePrograms, KeepTheNumbersOfLines) {
    const std::vector<std::string> lines{"O1",      "O2 (A)", "M30",      "%",      "X1",
                                         "M99",     "M98 P2", "/M2",      "N10 Y2", "\r",
                                         "GOTO 10", "o3 sub", "o3 endsub"};
    unsigned state = 1;
    for (int i = 0; i < 3000; ++i) {
        std::string text;
        for (int n = 0; n < 12; ++n) {
            state = state * 1664525U + 1013904223U;
            text += lines[(state >> 16) % lines.size()] + '\n';
        }
        const FilePrograms file = read(text);
        for (std::size_t p = 0; p < file.programs().size(); ++p)
            EXPECT_EQ(std::ranges::count(file.text_of(p, text), '\n'), 12);
    }
}

}  // namespace
}  // namespace ncsim::gcode
