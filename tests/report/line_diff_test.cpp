// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the comparison of lines.
#include "line_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {
namespace {

using Lines = std::vector<std::string_view>;

// Expects stretches that alternate, cover both texts, and are equal where they say so. Returns the
// number of equal lines.
std::size_t checked_equal(const Lines& a, const Lines& b) {
    std::size_t x = 0, y = 0, equal = 0;
    bool was_equal = false;
    for (const LineStretch& s : compare_lines(a, b)) {
        EXPECT_EQ(s.old_first, x);
        EXPECT_EQ(s.new_first, y);
        EXPECT_GT(s.old_count + s.new_count, 0U);
        EXPECT_TRUE(x + y == 0 || s.equal != was_equal);
        was_equal = s.equal;
        if (s.equal) {
            EXPECT_EQ(s.old_count, s.new_count);
            for (std::size_t i = 0; i < s.old_count; ++i)
                EXPECT_EQ(a.at(x + i), b.at(y + i));
            equal += s.old_count;
        }
        x += s.old_count;
        y += s.new_count;
    }
    EXPECT_EQ(x, a.size());
    EXPECT_EQ(y, b.size());
    return equal;
}

// Returns the length of the longest common subsequence, by the table of all prefixes.
std::size_t longest_common(const Lines& a, const Lines& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (const std::string_view line : a) {
        std::size_t diagonal = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = line == b[j] ? diagonal + 1 : std::max(above, row[j]);
            diagonal = above;
        }
    }
    return row.back();
}

TEST(CompareLines, FindsInsertedRemovedAndChangedLines) {
    const Lines a{"G21", "G0 X1", "G0 X2", "G0 X3", "M30"};
    const Lines b{"G21", "G0 X2", "G0 X4", "M5", "M30"};
    EXPECT_EQ(compare_lines(a, b), (std::vector<LineStretch>{{true, 0, 1, 0, 1},
                                                             {false, 1, 1, 1, 0},
                                                             {true, 2, 1, 1, 1},
                                                             {false, 3, 1, 2, 2},
                                                             {true, 4, 1, 4, 1}}));
}

TEST(CompareLines, HandlesEmptyAndEqualTexts) {
    EXPECT_TRUE(compare_lines({}, {}).empty());
    const Lines a{"x", "y"};
    EXPECT_EQ(compare_lines(a, a), (std::vector<LineStretch>{{true, 0, 2, 0, 2}}));
    EXPECT_EQ(compare_lines(a, {}), (std::vector<LineStretch>{{false, 0, 2, 0, 0}}));
    EXPECT_EQ(compare_lines({}, a), (std::vector<LineStretch>{{false, 0, 0, 0, 2}}));
}

TEST(CompareLines, FindsAsManyEqualLinesAsThereAre) {
    const Lines words{"a", "b", "c", "d"};
    std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same texts in each run
    for (int round = 0; round < 3000; ++round) {
        Lines a, b;
        const std::size_t kinds = 1 + random() % words.size();
        for (std::size_t i = random() % 12; i > 0; --i)
            a.push_back(words[random() % kinds]);
        for (std::size_t i = random() % 12; i > 0; --i)
            b.push_back(words[random() % words.size()]);
        EXPECT_EQ(checked_equal(a, b), longest_common(a, b)) << "round " << round;
    }
}

// More edits than the search keeps at a time.
TEST(CompareLines, OfLongTextsEndsSoon) {
    std::vector<std::string> texts;
    texts.reserve(12000);
    for (int i = 0; i < 12000; ++i)
        texts.push_back("N" + std::to_string(i));
    Lines a(texts.begin(), texts.end());
    Lines moved(a.begin() + 6000, a.end());
    moved.insert(moved.end(), a.begin(), a.begin() + 6000);
    checked_equal(a, moved);
    std::mt19937 random(2);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same texts in each run
    Lines few_kinds;
    few_kinds.reserve(a.size());
    for (int i = 0; i < 12000; ++i)
        few_kinds.push_back(texts[random() % 300]);
    Lines other(few_kinds.rbegin(), few_kinds.rend());
    EXPECT_GT(checked_equal(few_kinds, other), 1000U);
    // Two edits far apart in a long text.
    Lines b = a;
    b.erase(b.begin() + 10);
    b.insert(b.begin() + 10000, "M5");
    EXPECT_EQ(checked_equal(a, b), a.size() - 1);
}

}  // namespace
}  // namespace ncsim::report
