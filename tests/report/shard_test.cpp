// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/report/shard.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ncsim::report {
namespace {

TEST(Shards, DealEachProgramOnceAndEvenly) {
    test::Random random(5);
    std::vector<std::uint64_t> sizes(1000);
    for (std::uint64_t& size : sizes)
        size = static_cast<std::uint64_t>(random.between(0, 1'000'000));
    sizes[17] = 0;
    for (const std::uint32_t of : {1U, 2U, 7U, 64U, 2000U}) {
        std::vector<int> taken(sizes.size(), 0);
        std::vector<std::uint64_t> loads;
        for (std::uint32_t shard = 0; shard < of; ++shard) {
            const std::vector<std::size_t> mine = programs_of_shard(sizes, shard, of);
            EXPECT_TRUE(std::ranges::is_sorted(mine));
            std::uint64_t& load = loads.emplace_back(0);
            for (const std::size_t i : mine) {
                ++taken[i];
                load += sizes[i];
            }
        }
        EXPECT_EQ(std::ranges::count(taken, 1), 1000);
        const auto [least, most] = std::ranges::minmax(loads);
        // The largest load without its smallest program is at most the least load.
        if (of <= 64) {
            EXPECT_LE(most - least, 1'001'000U) << of;
        }
    }
}

TEST(Entry, ComesBackFromItsLine) {
    Entry entry{"a \"b\"\n.nc",
                "O0101",
                "failed",
                1,
                "text\n\twith ümläuts",
                "ncsim.toml",
                "known.json",
                "1 error",
                "34 of 36 rules by --ignore",
                "x: y\n",
                "  skipped",
                R"({"a":[1,2.5,"\u0001"]})",
                "{}",
                "{}",
                "::error\n",
                "1,2\n",
                "[]",
                "sub.nc\n",
                true,
                {}};
    const std::string line = line_of(entry);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(entry_from(line), entry);
    for (std::size_t cut : {line.size() - 1, line.size() / 2, std::size_t{0}})
        EXPECT_FALSE(entry_from(line.substr(0, cut))) << cut;
    // Program text may be invalid UTF-8 and may contain any bytes.
    for (int lead = 0; lead < 256; ++lead) {
        for (const char* tail : {"", "x", "\x80", "\x90\x80", "\x8f\xbf\xbf", "\xa0\x80", "\xbf"}) {
            entry.text = std::string("a") + static_cast<char>(lead) + tail;
            EXPECT_EQ(entry_from(line_of(entry)), entry) << lead << tail;
        }
    }
    EXPECT_FALSE(entry_from(R"({"code": 1})"));
    EXPECT_FALSE(entry_from("[]"));
}

}  // namespace
}  // namespace ncsim::report
