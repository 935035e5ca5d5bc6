// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of operations in comments.
#include "ncsim/toolpath/operation_name.h"

#include "ncsim/toolpath/tool_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

TEST(OperationName, IsWhatCamSystemsWrite) {
    const auto name = [](const char* comment) { return operation_name_of(comment).value_or(""); };
    EXPECT_EQ(name("2D CONTOUR1"), "2D CONTOUR1");
    EXPECT_EQ(name(" Begin operation: Adaptive001 "), "Adaptive001");
    EXPECT_EQ(name("---- F-CONTOUR1 - PROFILE ----"), "F-CONTOUR1 - PROFILE");
    EXPECT_EQ(name("Nr. 2: Ausschnitt 26"), "Nr. 2: Ausschnitt 26");
    EXPECT_EQ(name("*** Taschenfräsen ***"), "Taschenfräsen");
}

TEST(OperationName, IsNeitherASentenceNorAValueNorAMessage) {
    for (const char* comment :
         {"", "-----", "7", "X", "Z = 5", "MSG, Change the tool", "DEBUG,#5220",
          "Finish operation: Adaptive001", "Path: Adaptive001", "End cutting path id",
          "Spindle off.", "When using Fusion 360 for Personal Use, the feedrate of",
          "https://example.org/post"})
        EXPECT_FALSE(operation_name_of(comment)) << comment;
    EXPECT_FALSE(operation_name_of(std::string(61, 'A')));
    EXPECT_TRUE(operation_name_of(std::string(60, 'A')));
    EXPECT_TRUE(operation_name_of("FACE THE TOP OF THE PART")) << "six words";
    EXPECT_TRUE(operation_name_of("FACE  THE TOP  OF THE PART")) << "two blanks are one";
    EXPECT_FALSE(operation_name_of("FACE THE TOP OF THE PART FIRST")) << "seven words";
    EXPECT_FALSE(operation_name_of(std::string(100'000, '-') + "A B"));
}

std::vector<std::string> names_in(std::string text, const char* file = "part.nc") {
    std::vector<std::string> names;
    for (const OperationName& operation : read_notes({file, std::move(text)}).operations)
        names.push_back(std::to_string(operation.line) + " " + operation.name);
    return names;
}

TEST(OperationNames, StandAloneInTheirBlock) {
    EXPECT_EQ(names_in("O1000 (BRACKET)\nG21 (METRIC)\n(FACE1)\nN10 (POCKET2)\nG0 X5.\n"),
              (std::vector<std::string>{"3 FACE1", "4 POCKET2"}));
    EXPECT_TRUE(names_in("(T1 D=10. CR=0. - flat end mill)\nT1 M6\n(M6 T3)\nG0 X5.\n").empty());
}

TEST(OperationNames, AreReadInEveryLanguage) {
    EXPECT_EQ(
        names_in("0 BEGIN PGM A MM\n1 ; FACE 1\n2 TOOL CALL 1 Z S8000\n3 L X+5 FMAX ; LIFT OFF\n"
                 "4 * - POCKET 2\n5 END PGM A MM\n",
                 "part.h"),
        (std::vector<std::string>{"2 FACE 1", "5 POCKET 2"}));
    EXPECT_EQ(
        names_in("N10 G71 G90\nN20 ; FACE 1\nN30 T1 M6 ; CHANGE IT\n; POCKET 2\nM30\n", "part.mpf"),
        (std::vector<std::string>{"2 FACE 1", "4 POCKET 2"}));
}

TEST(OperationNames, AreNotRepeatedOverAndOver) {
    std::string text = "(FACE1)\n";
    for (int i = 0; i < 6; ++i)
        text += "(LAYER)\nG1 X5.\n";
    EXPECT_EQ(names_in(text), std::vector<std::string>{"1 FACE1"});
    text.clear();
    for (int i = 0; i < 300; ++i)
        text += "(LAYER " + std::to_string(i) + ")\nG1 X5.\n";
    EXPECT_TRUE(names_in(text).empty());
}

}  // namespace
}  // namespace ncsim::toolpath
