// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the UTF-8 filter and the shortest text of numbers.
#include "formats/file_text.h"

#include <gtest/gtest.h>

namespace ncsim::exporter {
namespace {

TEST(PrintableUtf8, LeavesGoodTextAlone) {
    EXPECT_EQ(printable_utf8("part-\xC3\xBC\xE2\x82\xAC\xF0\x9F\x94\xA7.nc"),
              "part-\xC3\xBC\xE2\x82\xAC\xF0\x9F\x94\xA7.nc");
}

TEST(PrintableUtf8, ReplacesWhatIsNotUtf8ByteByByte) {
    const std::string bad = "\xEF\xBF\xBD";
    for (const auto& [text, expected] :
         {std::pair<std::string, std::string>{"a\xFC"
                                              "b",
                                              "a" + bad + "b"},  // Latin-1
          {"\xC3", bad},                                         // cut off
          {"\xC0\xAF", bad + bad},                               // overlong
          {"\xED\xA0\x80", bad + bad + bad},                     // surrogate
          {"\xF4\x90\x80\x80", bad + bad + bad + bad},           // beyond Unicode
          {std::string("x\0\ny", 4), "x" + bad + bad + "y"}}) {
        SCOPED_TRACE(text);
        EXPECT_EQ(printable_utf8(text), expected);
    }
}

TEST(AppendNumber, WritesTheShortestTextThatReadsBack) {
    std::string text;
    for (const double number : {0.1, -0.0, 1.0, -12.5, 1e-7, 1.0 / 3.0}) {
        append_number(text, number);
        text += ' ';
    }
    EXPECT_EQ(text, "0.1 0 1 -12.5 1e-07 0.3333333333333333 ");
}

}  // namespace
}  // namespace ncsim::exporter
