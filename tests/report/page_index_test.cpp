// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the index of pages.
#include "ncsim/report/page_index.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::report {
namespace {

Entry entry_of(const std::string& path, const std::string& word) {
    Entry entry;
    entry.path = path;
    entry.word = word;
    return entry;
}

std::string index_of(const std::vector<Entry>& entries,
                     const std::map<std::string, IndexFacts>& facts, const Scope& scope = {},
                     LengthUnit unit = LengthUnit::Millimetre) {
    std::ostringstream out;
    write_page_index(
        out,
        [&](const auto& take) {
            for (const Entry& entry : entries)
                take(entry);
        },
        [&](const Entry& entry) {
            const auto found = facts.find(entry.path);
            return found == facts.end() ? nullptr : &found->second;
        },
        scope, unit);
    return out.str();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(PageIndex, ListsTheWorstVerdictsAndMostErrorsFirst) {
    std::map<std::string, IndexFacts> facts;
    facts["few.nc"].errors = 1;
    facts["many.nc"].errors = 7;
    const std::string index =
        index_of({entry_of("clean.nc", "clean"), entry_of("open.nc", "not-proven"),
                  entry_of("few.nc", "failed"), entry_of("many.nc", "failed"),
                  entry_of("broken.nc", "not-verified"), entry_of("fine.nc", "accepted")},
                 facts);
    std::size_t last = 0;
    for (const char* name : {"broken.nc", "many.nc", "few.nc", "open.nc", "fine.nc", "clean.nc"}) {
        const std::size_t place = index.find(name);
        EXPECT_GT(place, last) << name;
        last = place;
    }
    EXPECT_TRUE(contains(index, "<header class=\"not-verified\">"));
    EXPECT_TRUE(contains(index, "6 programs, 1 clean, 1 accepted, 1 not-proven, 2 failed, 1 not-"));
}

TEST(PageIndex, HasTimesVolumesAndCountsForTheScript) {
    IndexFacts facts;
    facts.page = "a.nc.html";
    facts.picture = "a.nc.png";
    facts.errors = 2;
    facts.doubts = 3;
    facts.seconds = 75.25;
    facts.removed_mm3 = 12500.0;
    const Entry entry = entry_of("a.nc", "failed");
    const std::string index = index_of({entry}, {{"a.nc", facts}});
    EXPECT_TRUE(contains(index, "data-label=\"errors\" data-value=\"2\">2<"));
    EXPECT_TRUE(contains(index, "data-label=\"warnings\" data-value=\"0\">0<"));
    EXPECT_TRUE(contains(index, "data-label=\"time\" data-value=\"75.250\">1:15 min<"));
    EXPECT_TRUE(contains(index, "data-label=\"removed\" data-value=\"12500\">12.500 cm3<"));
    EXPECT_TRUE(contains(index, "<a href=\"a.nc.html\">a.nc</a>"));
    EXPECT_TRUE(contains(index, "alt=\"part of a.nc\" src=\"a.nc.png\">"));
    EXPECT_TRUE(contains(index_of({entry}, {{"a.nc", facts}}, {}, LengthUnit::Inch),
                         "data-value=\"12500\">0.7628 in3<"));
    // Values that are not known are empty, not 0.
    const std::string none = index_of({entry_of("b.nc", "not-verified")}, {});
    EXPECT_TRUE(contains(none, "data-label=\"errors\" data-value=\"\"><"));
    EXPECT_TRUE(contains(none, "data-label=\"time\" data-value=\"\"><"));
    EXPECT_FALSE(contains(none, "<img"));
}

TEST(PageIndex, IsHarmlessForAnyNames) {
    IndexFacts facts;
    facts.page = "x.html";
    facts.failure = "cannot read '<script>alert(1)</script>\x1b[2J\xff'";
    const std::string path = "<img src=x onerror=\"alert(1)\">\n\x07&\xfe.nc";
    Scope scope;
    scope.excluded.push_back({"<u>\"", "a <i>kind</i>"});
    scope.called.push_back({"<s>sub", "<s>caller"});
    Entry entry = entry_of(path, "not-verified");
    entry.program = "<b>O1</b>";
    const std::string index = index_of({entry}, {{path, facts}}, scope);
    for (const char* bad :
         {"<img", "<script>alert", "<b>", "<u>", "<i>", "<s>", "\x1b", "\x07", "\xfe", "\xff"})
        EXPECT_FALSE(contains(index, bad)) << bad;
    EXPECT_TRUE(contains(index, "&lt;img src=x onerror=&quot;alert(1)&quot;&gt;"));
}

}  // namespace
}  // namespace ncsim::report
