// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that reports are made of: numbers, times, escapes, lines, fingerprints, JSON piece by
// piece.
#include "ncsim/report/machining_time.h"

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

TEST(TimeText, HasHoursFromSixtyMinutes) {
    EXPECT_EQ(time_text(0.0), "0:00 min");
    EXPECT_EQ(time_text(7.4), "0:07 min");
    EXPECT_EQ(time_text(7.5), "0:08 min");
    EXPECT_EQ(time_text(60.0), "1:00 min");
    EXPECT_EQ(time_text(3599.0), "59:59 min");
    EXPECT_EQ(time_text(3599.5), "1:00:00 h");
    EXPECT_EQ(time_text(3723.0), "1:02:03 h");
}

TEST(MachiningTime, HasTypicalRatesOfRapidsAndToolChanges) {
    // 20 m at 10 m/min are 2 min; three tool changes are 24 s.
    const verify::Distances sums{20'000.0, 5'000.0, 90.0, 6.0, 3};
    const MachiningTime time = time_of(sums);
    EXPECT_EQ(time.feed, 90.0);
    EXPECT_DOUBLE_EQ(time.rapid, 120.0);
    EXPECT_DOUBLE_EQ(time.tool_changes, 24.0);
    EXPECT_DOUBLE_EQ(time.dwells, 6.0);
    EXPECT_DOUBLE_EQ(*time.total(), 240.0);
    EXPECT_EQ(time_line(sums),
              "4:00 min: feed 1:30 min, rapid 2:00 min at 10 m/min, 3 tool changes of 8 s, dwells "
              "0:06 min; without acceleration");
    EXPECT_EQ(time_line(verify::Distances{10'000.0, 5'000.0, 30.0, 0.0, 1}),
              "1:38 min: feed 0:30 min, rapid 1:00 min at 10 m/min, 1 tool change of 8 s; without "
              "acceleration");
    EXPECT_EQ(time_line(verify::Distances{10'000.0, 5'000.0, std::nullopt, 0.0, 0}),
              "unknown, a feed is not specified: rapid 1:00 min at 10 m/min; without acceleration");
}

TEST(MachiningTime, OfALedgerNeedsAllThreeTimes) {
    verify::Ledger ledger;
    ledger.feed_seconds = 60.0, ledger.rapid_seconds = 5.0, ledger.other_seconds = 10.0;
    EXPECT_EQ(seconds_of(ledger), 75.0);
    EXPECT_EQ(time_line(ledger),
              "1:15 min: feed 1:00 min, rapid 0:05 min, the rest 0:10 min; as the machine is "
              "described");
    for (auto* part : {&ledger.feed_seconds, &ledger.rapid_seconds, &ledger.other_seconds}) {
        const auto known = std::exchange(*part, std::nullopt);
        EXPECT_FALSE(seconds_of(ledger));
        EXPECT_EQ(time_line(ledger), "");
        *part = known;
    }
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
