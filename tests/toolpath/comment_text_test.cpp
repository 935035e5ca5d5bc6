// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with units, and words, at the ends and in the middle of a text.
#include "tools/comment_text.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath::text {
namespace {

struct Row {
    std::string_view text;
    double value;
    Unit unit;
    bool is_fraction;
    std::size_t end;  // of number and unit
};

TEST(Quantity, HasAValueAUnitAndAnEnd) {
    for (const Row& row : std::vector<Row>{{"12", 12, Unit::None, false, 2},
                                           {".5", 0.5, Unit::None, false, 2},
                                           {"5.", 5, Unit::None, false, 2},
                                           {"-3.25Z", -3.25, Unit::None, false, 5},
                                           {"+3", 3, Unit::None, false, 2},
                                           {"1.2.3", 1.2, Unit::None, false, 3},
                                           {"1/4", 0.25, Unit::None, true, 3},
                                           {"-1/4", -0.25, Unit::None, true, 4},
                                           {"1-1/2", 1.5, Unit::None, true, 5},
                                           {"1 1/2", 1.5, Unit::None, true, 5},
                                           {"-1 1/2\"", -1.5, Unit::Inch, true, 7},
                                           {"1/0", 1, Unit::None, false, 1},
                                           {"1/", 1, Unit::None, false, 1},
                                           {"2 3", 2, Unit::None, false, 1},
                                           {"2-3", 2, Unit::None, false, 1},
                                           {"2 3/", 2, Unit::None, false, 1},
                                           {"6MM", 6, Unit::Millimetre, false, 3},
                                           {"6 MM", 6, Unit::Millimetre, false, 4},
                                           {"6\tMM X", 6, Unit::Millimetre, false, 4},
                                           {"6MMX", 6, Unit::None, false, 1},
                                           {"6M", 6, Unit::None, false, 1},
                                           {"3IN", 3, Unit::Inch, false, 3},
                                           {"3 INCH", 3, Unit::Inch, false, 6},
                                           {"3 INCHES.", 3, Unit::Inch, false, 8},
                                           {"3 INSERTS", 3, Unit::None, false, 1},
                                           {"3\"X", 3, Unit::Inch, false, 2},
                                           {"3''", 3, Unit::Inch, false, 3},
                                           {"3'", 3, Unit::Degree, false, 2},
                                           {"90DEG", 90, Unit::Degree, false, 5},
                                           {"90 DEGREE", 90, Unit::Degree, false, 9},
                                           {"90 DEGREES,", 90, Unit::Degree, false, 10},
                                           {"90 DEGA", 90, Unit::None, false, 2},
                                           {"90\xC2\xB0", 90, Unit::Degree, false, 4},
                                           {"90\xB0", 90, Unit::Degree, false, 3}}) {
        SCOPED_TRACE(row.text);
        for (const std::string& before : {std::string(), std::string("AB ")}) {
            const auto q = quantity_at(before + std::string(row.text), before.size());
            ASSERT_TRUE(q);
            EXPECT_DOUBLE_EQ(q->value, row.value);
            EXPECT_EQ(q->unit, row.unit);
            EXPECT_EQ(q->is_fraction, row.is_fraction);
            EXPECT_EQ(q->begin, before.size());
            EXPECT_EQ(q->end, before.size() + row.end);
        }
    }
}

TEST(Quantity, NeedsADigit) {
    for (const char* text : {"", ".", "-", "+.", "A1", " 1", "/4", "--1"})
        EXPECT_FALSE(quantity_at(text, 0)) << text;
    EXPECT_FALSE(quantity_at("12", 2)) << "behind the end";
    EXPECT_FALSE(quantity_at(std::string(400, '9'), 0)) << "beyond all numbers";
}

TEST(Words, StandWithoutAdjacentLetters) {
    EXPECT_EQ(find_word("CR CR=1", "CR"), 0U);
    EXPECT_EQ(find_word("CR CR=1", "CR", 1), 3U);
    EXPECT_EQ(find_word("SCR CRS CR", "CR"), 8U);
    EXPECT_EQ(find_word("1CR2", "CR"), 1U) << "digits are no letters";
    EXPECT_EQ(find_word("CR", "CR"), 0U);
    EXPECT_EQ(find_word("\xC3\xA4"
                        "CR",
                        "CR"),
              std::string_view::npos)
        << "ä is a letter";
    EXPECT_EQ(find_word("CR\xE4", "CR"), std::string_view::npos);
    EXPECT_EQ(find_word("", "CR"), std::string_view::npos);
    EXPECT_EQ(find_word("D=5 CR", "CR"), 4U);
    EXPECT_EQ(find_word("SCREW", "CR"), std::string_view::npos);
    EXPECT_TRUE(is_letter('z'));
    EXPECT_TRUE(is_letter('\x80'));
    EXPECT_FALSE(is_letter('9'));
    EXPECT_FALSE(is_letter('_'));
}

TEST(Split, KeepsEmptyParts) {
    using Parts = std::vector<std::string_view>;
    EXPECT_EQ(split("", ','), (Parts{""}));
    EXPECT_EQ(split("a", ','), (Parts{"a"}));
    EXPECT_EQ(split("a,,b,", ','), (Parts{"a", "", "b", ""}));
}

TEST(SaneLength, IsFromANanometreToAKilometre) {
    EXPECT_FALSE(is_sane_length(1e-6));
    EXPECT_TRUE(is_sane_length(1.001e-6));
    EXPECT_TRUE(is_sane_length(999'999.0));
    EXPECT_FALSE(is_sane_length(1e6));
    EXPECT_FALSE(is_sane_length(-1.0));
    EXPECT_FALSE(is_sane_length(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(is_sane_length(std::numeric_limits<double>::infinity()));
}

TEST(NumberText, IsRoundedToAMillionthAndQuoted) {
    EXPECT_EQ(number(6.0), "6");
    EXPECT_EQ(number(-0.0), "0");
    EXPECT_EQ(number(1.0 / 3.0), "0.333333");
    EXPECT_EQ(number(2.5e-7), "0");
    EXPECT_EQ(quoted("T1"), "'T1'");
    EXPECT_EQ(quoted(""), "''");
}

}  // namespace
}  // namespace ncsim::toolpath::text
