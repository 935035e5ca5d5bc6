// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests characters, numbers as text, and escapes.
#include "ncsim/base/ascii.h"
#include "ncsim/base/number_text.h"
#include "ncsim/base/utf8.h"
#include "ncsim/base/xml_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace ncsim {
namespace {

TEST(Ascii, BytesBeyondAsciiHaveNoCaseAndNoClass) {
    EXPECT_EQ(lowercase("G54 \xc4\xdc@[`{"), "g54 \xc4\xdc@[`{");
    EXPECT_EQ(uppercase("g54 \xe4\xfc@[`{"), "G54 \xe4\xfc@[`{");
    for (const char c : std::string_view("@[`{\xc4\xe4/:"))
        EXPECT_FALSE(is_letter(c) || is_digit(c)) << c;
    for (const char c : std::string_view("AZaz"))
        EXPECT_TRUE(is_letter(c)) << c;
    EXPECT_TRUE(is_digit('0') && is_digit('9') && is_blank(' ') && is_blank('\t'));
}

TEST(Ascii, BlanksAreTrimmedAtBothEnds) {
    EXPECT_EQ(trimmed(" \ta b\r"), "a b");
    EXPECT_EQ(trimmed("--a-", "-"), "a");
    EXPECT_EQ(trimmed(" \t"), "");
    EXPECT_EQ(trimmed(""), "");
}

TEST(NumberText, IsTheShortestThatReadsBack) {
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(-0.0), "-0");
    EXPECT_EQ(shortest(1.0 / 3.0), "0.3333333333333333");
    EXPECT_EQ(shortest(std::uint32_t{4'294'967'295}), "4294967295");
    std::string text = "x=";
    append_shortest(text, 2.5);
    EXPECT_EQ(text, "x=2.5");
}

TEST(NumberText, OnlyAWholeTextIsANumber) {
    EXPECT_EQ(number_in<double>("-2.5e1"), -25.0);
    EXPECT_EQ(number_in<int>("12"), 12);
    for (const std::string_view text : {"", "1 ", " 1", "+1", "1x", "x", "1.5.2"})
        EXPECT_FALSE(number_in<double>(text)) << text;
    EXPECT_FALSE(number_in<int>("1.5"));
    EXPECT_FALSE(number_in<std::uint8_t>("256"));
    EXPECT_FALSE(number_in<std::uint8_t>("-1"));
}

TEST(Utf8, TheFirstCharacterHasItsCodeAndLength) {
    const auto expect = [](std::string_view text, std::uint32_t code, std::size_t bytes) {
        const Character c = first_character(text);
        EXPECT_TRUE(c.is_valid()) << text;
        EXPECT_EQ(c.code, code) << text;
        EXPECT_EQ(c.bytes, bytes) << text;
    };
    expect("ab", 'a', 1);
    expect("\xc3\xa4x", 0xe4, 2);
    expect("\xdf\xbf", 0x7ff, 2);
    expect("\xe0\xa0\x80", 0x800, 3);
    expect("\xef\xbf\xbd", 0xfffd, 3);
    expect("\xf0\x90\x80\x80", 0x10000, 4);
    expect("\xf4\x8f\xbf\xbf", 0x10ffff, 4);
}

TEST(Utf8, OtherBytesAreInvalidOneByOne) {
    for (const std::string_view text :
         {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xed\xbf\xbf",
          "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xc3", "\xc3x",
          "\xe2\x82", "\xe2\x82x", "\xf0\x9f\x98"}) {
        const Character c = first_character(text);
        EXPECT_FALSE(c.is_valid()) << text;
        EXPECT_EQ(c.bytes, 1U);
        EXPECT_EQ(c.code, 0xfffdU);
        EXPECT_FALSE(c.is_control());
    }
}

TEST(Utf8, ControlCharactersAreThoseThatSteerATerminal) {
    for (const std::uint32_t code :
         {0x0U, 0x1fU, 0x7fU, 0x9fU, 0x61cU, 0x200eU, 0x200fU, 0x2028U, 0x202eU, 0x2066U, 0x2069U})
        EXPECT_TRUE((Character{code, 1}.is_control())) << code;
    for (const std::uint32_t code : {0x20U, 0x7eU, 0xa0U, 0x61bU, 0x61dU, 0x200dU, 0x2010U, 0x2027U,
                                     0x202fU, 0x2065U, 0x206aU})
        EXPECT_FALSE((Character{code, 1}.is_control())) << code;
}

TEST(XmlText, HasEscapes) {
    EXPECT_EQ(xml_escaped("a<b> & \"c\" '\xc3\xa4'"), "a&lt;b&gt; &amp; &quot;c&quot; '\xc3\xa4'");
}

}  // namespace
}  // namespace ncsim
