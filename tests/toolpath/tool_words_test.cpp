// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of tool descriptions: their forms in a comment, and the tables of numbered sizes.
#include "tools/tool_words.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ncsim::toolpath::words {
namespace {

// Returns tokens as text, "_" where a token is joined to its neighbour.
std::string tokens(const std::string& comment) {
    std::string text;
    for (const Token& token : tokens_of(plain_upper(comment))) {
        if (!text.empty()) text += ' ';
        if (token.joined_left) text += '_';
        text += token.text;
        if (token.joined_right) text += '_';
    }
    return text;
}

TEST(Tokens, KnowTheirNeighbours) {
    EXPECT_EQ(tokens("6mm end mill"), "6MM END MILL");
    EXPECT_EQ(tokens("6mm end-mill#2"), "6MM END MILL_ _#_ _2");
    EXPECT_EQ(tokens("end mill5"), "END MILL_ _5");
    EXPECT_EQ(tokens("5end mill 2"), "5_ _END MILL 2");
    EXPECT_EQ(tokens("end_mill"), "END MILL");
    EXPECT_EQ(tokens("end - mill"), "END - MILL") << "a mark between blanks joins nothing";
    EXPECT_EQ(tokens("T1|x"), "T_ _1_ _|_ _X");
    EXPECT_EQ(tokens(""), "");
    EXPECT_EQ(tokens(" \t\r"), "");
    EXPECT_EQ(tokens("dia. off. 3"), "DIA OFF_ _. 3");
}

TEST(Tokens, ReadNumbersAsPeopleWriteThem) {
    const auto value = [](const std::string& comment, std::size_t at) {
        const std::vector<Token> all = tokens_of(plain_upper(comment));
        return at < all.size() && all[at].is_number() ? all[at].quantity.value : -1.0;
    };
    EXPECT_EQ(value("6,35", 0), 6.35) << "a decimal comma";
    EXPECT_EQ(value("6,35mm", 0), 6.35);
    EXPECT_EQ(value("6,35,7", 0), 6.0) << "a list";
    EXPECT_EQ(value("6,35.7", 0), 6.0);
    EXPECT_EQ(value("6.5,35", 0), 6.5);
    EXPECT_EQ(value("6mm,35", 0), 6.0);
    EXPECT_EQ(value("1/4,35", 0), 0.25);
    EXPECT_EQ(value("6,", 0), 6.0);
    EXPECT_EQ(value("1 1/2", 0), 1.5);
    EXPECT_EQ(value("tool 1 1/2", 1), 1.0) << "tool 1 of half an inch";
    EXPECT_EQ(value("tool 1 1/2", 2), 0.5);
    EXPECT_EQ(value("tool 1 .5", 1), 1.0);
    EXPECT_EQ(value("tool 1 .5", 2), 0.5);
    EXPECT_EQ(value("no 1 1/2", 2), 0.5);
    EXPECT_EQ(value("# 1 1/2", 2), 0.5);
    EXPECT_EQ(value("t 1 1/2", 2), 0.5);
    EXPECT_EQ(value("drill 1 1/2", 1), 1.5);
    EXPECT_EQ(value("tool 1-1/2", 1), 1.5);
}

TEST(PlainUpper, ReplacesLettersWithMarks) {
    for (const auto& [text, plain] :
         std::vector<std::pair<std::string, std::string>>{{"fr\xC3\xA4ser", "FRAESER"},
                                                          {"fr\xE4ser", "FRAESER"},
                                                          {"\xC3\x9F", "SS"},
                                                          {"\xC3\xA9\xC3\xA8", "EE"},
                                                          {"\xC3\xB6\xC3\xBC", "OEUE"},
                                                          {"\xC3\x98"
                                                           "6",
                                                           "DIA 6"},
                                                          {"\xD8"
                                                           "6",
                                                           "DIA 6"},
                                                          {"\xE2\x8C\x80"
                                                           "6",
                                                           "DIA 6"},
                                                          {"2\xC3\x97"
                                                           "3",
                                                           "2X3"},
                                                          {"\xC3\xB1", "N"},
                                                          {"90\xC2\xB0", "90\xB0"},
                                                          {"90\xC2\xBA", "90\xB0"},
                                                          {"a\xC2\xA0z", "A Z"},
                                                          {"\xFF", " "},
                                                          {"\xC3", "A"},
                                                          {"\xC3(", "A("}}) {
        EXPECT_EQ(plain_upper(text), plain) << text;
    }
}

TEST(KindNamed, IsTheMostSpecialWord) {
    EXPECT_EQ(kind_named("tapered ball end mill"), ToolKind::TaperedEndMill);
    EXPECT_EQ(kind_named("ball end mill"), ToolKind::BallEndMill);
    EXPECT_EQ(kind_named("end mill, ball"), ToolKind::BallEndMill);
    EXPECT_EQ(kind_named("drill"), ToolKind::Drill);
    EXPECT_EQ(kind_named("spot drill"), ToolKind::VCutter);
    EXPECT_EQ(kind_named("thread mill"), ToolKind::ThreadMill);
    EXPECT_EQ(kind_named("cutter"), std::nullopt);
    EXPECT_EQ(kind_named(""), std::nullopt);
    // Words beyond the first 200 bytes do not count.
    EXPECT_EQ(kind_named(std::string(195, 'X') + " DRILL"), std::nullopt);
    EXPECT_EQ(kind_named(std::string(194, 'X') + " DRILL"), ToolKind::Drill);
}

TEST(NumberedSizes, EndWhereTheTablesEnd) {
    EXPECT_EQ(number_drill(0), 0.0);
    EXPECT_EQ(number_drill(1), 0.228);
    EXPECT_EQ(number_drill(7), 0.201);
    EXPECT_EQ(number_drill(36), 0.1065);
    EXPECT_EQ(number_drill(60), 0.040);
    EXPECT_EQ(number_drill(80), 0.0135);
    EXPECT_EQ(number_drill(81), 0.0);
    EXPECT_EQ(letter_drill('A'), 0.234);
    EXPECT_EQ(letter_drill('F'), 0.257);
    EXPECT_EQ(letter_drill('Z'), 0.413);
    EXPECT_EQ(letter_drill('@'), 0.0);
    EXPECT_EQ(letter_drill('['), 0.0);
    EXPECT_EQ(centre_drill(0), 0.0);
    EXPECT_EQ(centre_drill(1), 0.125);
    EXPECT_EQ(centre_drill(5), 0.4375);
    EXPECT_EQ(centre_drill(8), 0.75);
    EXPECT_EQ(centre_drill(9), 0.0);
    EXPECT_EQ(number_screw(-1), 0.0);
    EXPECT_EQ(number_screw(0), 0.060);
    EXPECT_DOUBLE_EQ(number_screw(10), 0.190);
    EXPECT_DOUBLE_EQ(number_screw(14), 0.242);
    EXPECT_EQ(number_screw(15), 0.0);
    EXPECT_EQ(coarse_pitch(1.0), 0.25);
    EXPECT_EQ(coarse_pitch(8.0), 1.25);
    EXPECT_EQ(coarse_pitch(36.0), 4.0);
    EXPECT_EQ(coarse_pitch(9.0), 0.0);
}

TEST(NumberedSizes, FallFromNumberToNumberAndRiseFromLetterToLetter) {
    for (int i = 2; i <= 80; ++i)
        EXPECT_LT(number_drill(i), number_drill(i - 1)) << i;
    for (char c = 'B'; c <= 'Z'; ++c)
        EXPECT_GT(letter_drill(c), letter_drill(static_cast<char>(c - 1))) << c;
    EXPECT_GT(letter_drill('A'), number_drill(1));
}

}  // namespace
}  // namespace ncsim::toolpath::words
