// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests background tasks and parallel sorting.
#include "ncsim/base/parallel.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <latch>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace ncsim {
namespace {

TEST(Background, DoesEachTaskOnce) {
    for (const std::size_t others : {0U, 1U, 3U, 9U}) {
        std::vector<std::atomic<int>> done(7);
        Background background(others, done.size(), [&](std::size_t i) { ++done[i]; });
        background.finish();
        for (const auto& times : done)
            EXPECT_EQ(times, 1) << others;
    }
    Background(3, 0, [](std::size_t) { FAIL(); }).finish();
}

// After the task has begun, it waits for an action of the caller.
TEST(Background, BeginsWhileTheCallerGoesOn) {
    std::latch has_begun(1), goes_on(1);
    Background background(1, 1, [&](std::size_t) {
        has_begun.count_down();
        goes_on.wait();
    });
    has_begun.wait();
    goes_on.count_down();
    background.finish();
}

TEST(Background, ThrowsWhatATaskThrew) {
    for (const std::size_t others : {0U, 2U}) {
        std::atomic<int> begun = 0;
        Background background(others, 1000, [&](std::size_t) {
            ++begun;
            throw std::runtime_error("no");
        });
        EXPECT_THROW(background.finish(), std::runtime_error);
        EXPECT_LE(begun, static_cast<int>(others) + 1);
    }
}

TEST(Background, BeginsNoMoreWhereNobodyWaits) {
    std::atomic<std::size_t> ended = 0;
    std::atomic<std::size_t> begun = 0;
    {
        const Background background(2, 1U << 30, [&](std::size_t) {
            ++begun;
            ++ended;
        });
    }
    EXPECT_EQ(begun, ended);
    EXPECT_LT(begun, std::size_t{1} << 30);
}

TEST(SortInParallel, IsSortedWhateverTheThreads) {
    test::Random random(3);
    for (const std::size_t count : {0U, 1U, 5000U, 40001U}) {
        std::vector<std::uint32_t> sorted(count);
        std::iota(sorted.begin(), sorted.end(), 0U);
        std::vector<std::uint32_t> shuffled = sorted;
        for (std::size_t i = count; i > 1; --i) {
            const auto j = random.between(0, static_cast<std::int64_t>(i) - 1);
            std::swap(shuffled[i - 1], shuffled[static_cast<std::size_t>(j)]);
        }
        for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
            std::vector<std::uint32_t> items = shuffled;
            sort_in_parallel(threads, items, std::less{});
            EXPECT_EQ(items, sorted) << count << ' ' << threads;
        }
    }
}

}  // namespace
}  // namespace ncsim
