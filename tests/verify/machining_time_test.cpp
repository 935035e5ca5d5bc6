// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/machining_time.h"

#include <gtest/gtest.h>

#include <optional>

namespace ncsim::verify {
namespace {

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
    const Distances sums{20'000.0, 5'000.0, 90.0, 6.0, 3};
    const MachiningTime time = time_of(sums);
    EXPECT_EQ(time.feed, 90.0);
    EXPECT_DOUBLE_EQ(time.rapid, 120.0);
    EXPECT_DOUBLE_EQ(time.tool_changes, 24.0);
    EXPECT_DOUBLE_EQ(time.dwells, 6.0);
    EXPECT_DOUBLE_EQ(*time.total(), 240.0);
    EXPECT_EQ(time_line(sums),
              "4:00 min: feed 1:30 min, rapid 2:00 min at 10 m/min, 3 tool changes of 8 s, dwells "
              "0:06 min; without acceleration");
    EXPECT_EQ(time_line(Distances{10'000.0, 5'000.0, 30.0, 0.0, 1}),
              "1:38 min: feed 0:30 min, rapid 1:00 min at 10 m/min, 1 tool change of 8 s; without "
              "acceleration");
    EXPECT_EQ(time_line(Distances{10'000.0, 5'000.0, std::nullopt, 0.0, 0}),
              "unknown, a feed is not specified: rapid 1:00 min at 10 m/min; without acceleration");
}

TEST(MachiningTime, OfALedgerNeedsAllThreeTimes) {
    Ledger ledger;
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

}  // namespace
}  // namespace ncsim::verify
