// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parallel work with results in order.
#include "cli/run_program.h"
#include "system/ordered_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stdexcept>

namespace ncsim::cli_test {
namespace {

TEST(InOrder, ResultsArriveInTheOrderOfTheWork) {
    for (const unsigned jobs : {1U, 3U, 200U}) {
        std::vector<int> made(100);
        std::vector<std::size_t> seen;
        app::run_in_order(
            made.size(), jobs, [&](std::size_t i, const std::stop_token&) { made[i] = 7; },
            [&](std::size_t i) {
                EXPECT_EQ(made[i], 7);
                seen.push_back(i);
            },
            [](std::size_t) {});
        ASSERT_EQ(seen.size(), made.size());
        for (std::size_t i = 0; i < seen.size(); ++i)
            EXPECT_EQ(seen[i], i);
    }
    app::run_in_order(
        0, 2, [](std::size_t, const std::stop_token&) { FAIL(); }, [](std::size_t) { FAIL(); },
        [](std::size_t) { FAIL(); });
}

TEST(InOrder, WorkEndsWhenNobodyTakesItsResults) {
    std::mutex mutex;
    std::condition_variable_any changed;
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t i, const std::stop_token& stop) {
        ++begun;
        if (i == 0) return;
        std::unique_lock lock(mutex);
        // waits until a stop is requested
        EXPECT_FALSE(changed.wait(lock, stop, [] { return false; }));
    };
    EXPECT_THROW(app::run_in_order(
                     1000, 2, work, [](std::size_t) { throw std::runtime_error("closed"); },
                     [](std::size_t) {}),
                 std::runtime_error);
    EXPECT_LE(begun, 3);
}

TEST(ClosedOutput, EndsACheckWithAnError) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const std::string check = R"("$0" check slot.nc slot.nc slot.nc --json a.json)";
    // The reader of the pipe is closed before the first write.
    const Ran pipe = folder.shell("mkfifo p; exec 3<>p; exec 4>p; exec 3<&-; rm p; " + check +
                                  " >&4 4>&-; echo code $?");
    EXPECT_EQ(pipe.out, "code 2\n");
    EXPECT_NE(pipe.err.find("Broken pipe"), std::string::npos) << pipe.err;
    EXPECT_EQ(pipe.err.find('\n'), pipe.err.size() - 1) << pipe.err;
    const Ran closed = folder.shell("exec 3>&1; " + check + " >&-; echo code $? >&3");
    EXPECT_EQ(closed.out, "code 2\n");
    EXPECT_NE(closed.err.find("Bad file descriptor"), std::string::npos) << closed.err;
    EXPECT_EQ(folder.files(), std::vector<std::string>{"slot.nc"});
}

}  // namespace
}  // namespace ncsim::cli_test
