// SPDX-License-Identifier: GPL-3.0-or-later
//
// APPR and DEP of Klartext that are refused. The paths are in tests/programs/klartext-approach*.
#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode::klartext_test {
namespace {

TEST(KlartextApproach, Refusals) {
    const auto expect_error = [](const std::string& blocks, const std::string& error) {
        const Made r = run(klartext(blocks));
        EXPECT_EQ(r.errors().substr(0, error.size()), error) << blocks;
        EXPECT_TRUE(r.result.refused) << blocks;
    };
    expect_error("APPR LT X+1 Y+1 RL F100\nL Y+9", "4:1: APPR LT needs a length (LEN)");
    expect_error("APPR CT X+1 Y+1 R5 RL F100\nL Y+9",
                 "4:1: APPR CT needs a centre angle (CCA) up to 360");
    expect_error("APPR CT X+1 Y+1 CCA90 R+5 F100\nL Y+9", "4:1: APPR CT needs RL or RR");
    expect_error("APPR LN LEN5 RL F100\nL Y+9",
                 "4:1: APPR LN needs the first point of the contour");
    expect_error("APPR LT X+1 Y+1 LEN5 RL F100\nTOOL CALL 2 Z",
                 "4:1: APPR without a path block after it is not read");
    expect_error("APPR LCT X+1 Y+5 R500 RL F100\nL Y+9",
                 "4:1: APPR LCT needs a start outside the arc");
    expect_error("L X+9 RL F100\nAPPR LT X+20 Y+1 LEN5 RL F100\nL Y+9",
                 "5:1: APPR under RL or RR is not read");
    expect_error("DEP LT LEN5", "4:1: DEP LT needs a move in the plane before");
    expect_error("L X+9 F100\nDEP LN LEN5", "5:1: DEP LN needs cutter compensation (RL, RR)");
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
