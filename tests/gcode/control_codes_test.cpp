// SPDX-License-Identifier: GPL-3.0-or-later
//
// Codes and language elements that a program uses and a control lacks.
#include "ncsim/gcode/control_codes.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace ncsim::gcode {
namespace {

// Returns missing codes as "G81 3:1 x2, M6? 1:4 x1": code, position of the first use, number of
// uses; '?' for options, '*' for unknown.
std::string lacking(const std::string& control, const std::string& program) {
    std::string text;
    for (const CodeUse& use : missing_codes({"p.nc", program}, *find_control_codes(control))) {
        text += (text.empty() ? "" : ", ") + use.what +
                (use.support == CodeSupport::Option    ? "? "
                 : use.support == CodeSupport::Unknown ? "* "
                                                       : " ") +
                std::to_string(use.first.line) + ":" + std::to_string(use.first.column) + " x" +
                std::to_string(use.count);
    }
    return text;
}

TEST(ControlCodes, OfGrblHaveNeitherCyclesNorVariables) {
    EXPECT_EQ(lacking("grbl", "G21 G90\nG0 X0\nG1 X5 F100\nG2 X6 R3\nM2\n"), "");
    EXPECT_EQ(lacking("grbl", "G21\nG81 X1 Z-1 R1\nG81 X2\nM7\nM6 T1\n"),
              "G81 2:1 x2, M7? 4:1 x1, M6 5:1 x1");
    EXPECT_EQ(lacking("grbl", "#1=5\nG1 X#1\nG1 X[1+2]\n/G1 X5\n"),
              "variables 1:1 x2, expressions 3:4 x1, lines that begin with '/' 4:1 x1");
    EXPECT_EQ(lacking("linuxcnc", "/G1 X5\nG1 X5 /M8\n"), "'/' within a line 2:7 x1");
    EXPECT_EQ(lacking("haas", "/G1 X5\nG1 X5 /M8\n"), "");
    EXPECT_EQ(lacking("grbl", "o1 sub\no1 endsub\n"), "O-words (sub, if, while) 1:1 x2");
    EXPECT_EQ(lacking("grbl", "G59.1\nG38.3 Z-1\n"), "G59.1 1:1 x1");
    EXPECT_EQ(lacking("grbl", "(G81 M6)\nG1 X1 ; G41\n"), "") << "comments";
}

TEST(ControlCodes, KnowWordsOfOtherControlsApart) {
    EXPECT_EQ(lacking("smoothieware", "G2 X5 R3\nX6 R4\nG0 X1 R4\n"), "arcs by radius (R) 1:7 x2");
    EXPECT_EQ(lacking("linuxcnc", "G1 X5,R2\nIF[#1EQ1]GOTO5\n"),
              "corners by ,R and ,C 1:6 x1, IF, WHILE and GOTO of Macro B 2:1 x1");
    EXPECT_EQ(lacking("fanuc", "G1 X5,R2\nIF[#1EQ1]GOTO5\n"), "");
    EXPECT_EQ(lacking("linuxcnc", "M150\nM200\nG5.2 X1 Y1\nG61.1\n"), "M200 2:1 x1");
    EXPECT_EQ(lacking("haas", "G187 P1\nG154 P3\n"), "");
}

// No report would mean "the control has all codes".
TEST(ControlCodes, ThatCannotBeJudgedAreNamed) {
    EXPECT_EQ(lacking("fanuc", "G1 X5\nG#100 X6\nM[1+2]\n"), "codes by expressions* 2:1 x2");
    EXPECT_EQ(lacking("linuxcnc", "G1 X[ Y5\nG1 X2\n"), "lines that ncsim cannot read* 1:1 x1");
    EXPECT_EQ(lacking("linuxcnc", ""), "files without NC words* 1:1 x1");
    EXPECT_EQ(lacking("grbl", "0 BEGIN PGM A MM\n1 L X+1 Y+1 R0 FMAX\n"),
              "reader for the language of Heidenhain controls 1:1 x1");
    EXPECT_EQ(lacking("grbl", "G1 X1 A90\nA80 C5\n"), "axis A 1:7 x2, axis C 2:5 x1");
    EXPECT_EQ(lacking("fluidnc", "G1 X1 A90\n"), "");
}

// A row needs a source, and codes that the reader of the row can produce.
TEST(ControlCodes, AreATableWithSources) {
    std::set<std::string> names;
    for (const ControlCodes& control : all_control_codes()) {
        EXPECT_TRUE(names.emplace(control.name).second) << control.name;
        EXPECT_FALSE(control.source.empty()) << control.name;
        EXPECT_FALSE(control.otherwise.empty()) << control.name;
        for (const double g : {0.0, 1.0, 2.0, 3.0, 4.0, 17.0, 28.0, 54.0, 90.0, 91.0})
            EXPECT_EQ(support_of(control, 'G', g), CodeSupport::Yes) << control.name << " G" << g;
        for (const double g : {6.5, 54.9, 1234.0, 5000.0, -1.0})
            EXPECT_EQ(support_of(control, 'G', g), CodeSupport::No) << control.name << " G" << g;
    }
    for (const char* name : {"grbl", "grblhal", "fluidnc", "smoothieware", "tinyg", "mach3",
                             "mach4", "linuxcnc", "haas", "fanuc", "centroid", "carvera"})
        EXPECT_TRUE(find_control_codes(name)) << name;
    EXPECT_FALSE(find_control_codes("GRBL 2"));
}

}  // namespace
}  // namespace ncsim::gcode
