// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests programs side by side.
#include "program_diff.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace ncsim::report {
namespace {

std::string numbered(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i)
        text += "N" + std::to_string(i) + "\n";
    return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(ProgramDiff, PutsChangedLinesSideBySideWithTheChangeMarked) {
    const ProgramDiff diff = program_diff({"G21\nG1 X50. F800.\nM30\n", {}, {}},
                                          {"G21\r\nG1 X50. F700.\r\nM5\r\nM30", {}, {}}, "s1");
    EXPECT_EQ(diff.removed, 1U);
    EXPECT_EQ(diff.added, 2U);
    EXPECT_TRUE(contains(diff.html,
                         "<tr class=\"changed\"><td class=\"no\" id=\"s1o-2\">2</td>"
                         "<td class=\"old\"><del>G1 X50. F<mark>8</mark>00.</del></td>"
                         "<td class=\"no\" id=\"s1n-2\">2</td>"
                         "<td class=\"new\"><ins>G1 X50. F<mark>7</mark>00.</ins></td></tr>"))
        << diff.html;
    EXPECT_TRUE(
        contains(diff.html, "<td class=\"none\"></td><td class=\"no\" id=\"s1n-3\">3</td>"));
    EXPECT_TRUE(diff.shown_old.at(3) && diff.shown_new.at(4));
}

TEST(ProgramDiff, FoldsLongEqualStretchesButNoMarkedLine) {
    const std::string text = numbered(100);
    const MarkedProgram old_program{text, {{40, 42, 7}}, {40}};
    const MarkedProgram new_program{replaced(text, "N80\n", "G4 P1\n"), {}, {}};
    const ProgramDiff diff = program_diff(old_program, new_program, "s1");
    // Lines 1-38, 42-76 and 84-100.
    for (const char* fold : {"38 equal lines", "35 equal lines", "17 equal lines"})
        EXPECT_TRUE(contains(diff.html, std::string("<summary class=\"fold\">") + fold)) << fold;
    EXPECT_EQ(count_of(diff.html, "<details>"), 3U);
    EXPECT_TRUE(contains(diff.html,
                         "id=\"s1o-40\"><a class=\"region\" href=\"#s1r-7\" title=\"difference 7\">"
                         "7</a>40</td>"))
        << diff.html;
    EXPECT_EQ(count_of(diff.html, "href=\"#s1r-7\""), 3U);
}

TEST(ProgramDiff, OfEqualProgramsIsOneFold) {
    const ProgramDiff diff = program_diff({numbered(50), {}, {}}, {numbered(50), {}, {}}, "s1");
    EXPECT_EQ(diff.removed + diff.added, 0U);
    EXPECT_EQ(diff.html.find("<details><summary class=\"fold\">50 equal lines"), 0U) << diff.html;
    EXPECT_EQ(program_diff({}, {}, "s1").html, "");
}

TEST(ProgramDiff, LimitsTheSizeOfThePage) {
    const std::string text = numbered(30'000);
    const MarkedProgram program{text, {}, {}};
    const ProgramDiff equal = program_diff(program, {text + "M30\n", {}, {}}, "s1");
    EXPECT_TRUE(contains(equal.html, "<p class=\"fold\">29997 equal lines</p>"));
    EXPECT_LT(equal.html.size(), 2000U);
    EXPECT_FALSE(equal.shown_old.at(1000));
    std::string other;
    for (int i = 0; i < 30'000; ++i)
        other += "X" + std::to_string(i) + "\n";
    const ProgramDiff all = program_diff(program, {other, {}, {}}, "s1");
    EXPECT_EQ(all.removed, 30'000U);
    EXPECT_TRUE(contains(all.html, "The following lines are not shown."));
    EXPECT_LT(all.html.size(), 10'000'000U);
    EXPECT_TRUE(all.shown_old.at(20'000));
    EXPECT_FALSE(all.shown_old.at(20'001));
    const std::string most = numbered(20'000);
    EXPECT_FALSE(contains(program_diff({most, {}, {}}, {}, "s1").html, "not shown"));
}

TEST(ProgramDiff, IsHarmlessForAnyText) {
    const ProgramDiff diff = program_diff(
        {"(</td><script>alert(1)</script>)\n\x1b[2J\xff\n(caf\xc3\xa9)\n", {}, {}},
        {"(</td><script>alert(2)</script>)\n\x07\n(caf\xc3\xa8)\n" + std::string(100'000, 'X'),
         {},
         {}},
        "s1");
    for (const char* bad : {"<script", "\x1b", "\x07"})
        EXPECT_FALSE(contains(diff.html, bad)) << bad;
    // Marks do not cut characters, and long lines are cut.
    EXPECT_TRUE(contains(diff.html, "(caf<mark>\xc3\xa9</mark>)")) << diff.html;
    EXPECT_LT(diff.html.size(), 5000U);
}

}  // namespace
}  // namespace ncsim::report
