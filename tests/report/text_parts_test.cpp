// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that reports are made of: numbers, escapes, lines, fingerprints, JSON piece by piece.
#include "fingerprint.h"
#include "json.h"
#include "json_stream.h"
#include "markup.h"
#include "plain_number.h"
#include "source_lines.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {
namespace {

TEST(PlainNumber, IsTheShortestTextToAMillionth) {
    EXPECT_EQ(plain_number(0.0), "0");
    EXPECT_EQ(plain_number(-0.0), "0");
    EXPECT_EQ(plain_number(-1e-7), "0");
    EXPECT_EQ(plain_number(0.1 + 0.2), "0.3");
    EXPECT_EQ(plain_number(25.4 / 25.4 * 3), "3");
    EXPECT_EQ(plain_number(-12.3456784), "-12.345678");
    EXPECT_EQ(plain_number(-12.3456786), "-12.345679");
}

TEST(Markup, EscapesWhatTagsAndAttributesMean) {
    EXPECT_EQ(escaped("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c'");
    EXPECT_EQ(escaped("&amp;"), "&amp;amp;");
    EXPECT_EQ(escaped("\xC3\xA4"), "\xC3\xA4");
    EXPECT_EQ(valid_utf8("a\xC3\xA4"), "a\xC3\xA4");
    EXPECT_EQ(valid_utf8("a\xC3"), "a\xEF\xBF\xBD");
    EXPECT_EQ(valid_utf8("\xFFz"), "\xEF\xBF\xBDz");
}

TEST(SourceLines, EndInAnyLineEnd) {
    using Lines = std::vector<std::string_view>;
    EXPECT_EQ(lines_of("a\nb\r\nc\rd"), (Lines{"a", "b", "c", "d"}));
    EXPECT_EQ(lines_of("a\n"), Lines{"a"});
    EXPECT_EQ(lines_of("a\n\nb"), (Lines{"a", "", "b"}));
    EXPECT_EQ(lines_of("a\r\r\nb"), (Lines{"a", "", "b"}));
}

TEST(Fingerprint, IsThatOfItsSource) {
    // Test vectors of FNV-1a with 64 bits.
    EXPECT_EQ(fingerprint(""), "cbf29ce484222325");
    EXPECT_EQ(fingerprint("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(fingerprint("foobar"), "85944171f73967e8");
}

TEST(JsonStream, WritesTheBytesOfTheWholeValue) {
    const Json inner{{"x", 1}, {"list", {1, 2}}, {"text", "two\nlines"}};
    Json whole;
    whole["empty"] = Json::object();
    whole["none"] = Json::array();
    whole["inner"] = inner;
    whole["list"] = Json::array({inner, 3, Json::array({inner})});
    whole["last"] = nullptr;
    std::ostringstream out;
    JsonStream stream(out);
    stream.begin_object();
    stream.begin_object("empty");
    stream.end();
    stream.begin_array("none");
    stream.end();
    stream.value("inner", inner);
    stream.begin_array("list");
    stream.element(inner);
    stream.element(3);
    stream.begin_array();
    stream.element(inner);
    stream.end();
    stream.end();
    stream.value("last", nullptr);
    stream.end();
    EXPECT_EQ(out.str(), to_text(whole));
}

}  // namespace
}  // namespace ncsim::report
