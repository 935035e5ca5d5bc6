// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rules on both sides of their limits: poses in which a joint turns far, lengths of tools that
// differ in rounding.
#include "ncsim/machine/presets.h"

#include "finding_log.h"
#include "rule_table.h"
#include "verify/expected.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace ncsim::verify_test {
namespace {

using verify::Finding;

gcode::Position at(double x, double b, double c) {
    gcode::Position p;
    p.x = gcode::Length::from_mm(x);
    p.b = gcode::Angle::from_degrees(b);
    p.c = gcode::Angle::from_degrees(c);
    return p;
}

/// Findings of singular-pose for a move under tip control on a head that leans by B, over a table
/// that turns by C. With B at `lean`, a turn of C by 170 degrees leans the tool by
/// 2 sin(lean) sin(85).
std::size_t singular(double lean, double turn, gcode::MoveKind kind = gcode::MoveKind::Feed,
                     gcode::Coordinates coordinates = gcode::Coordinates::Tip) {
    verify::Setup setup = not_simulated();
    setup.kinematics = std::make_shared<const toolpath::Kinematics>(
        toolpath::Kinematics{*machine::preset("head-b-table-c"), {}});
    gcode::Motion motion;
    motion.action = gcode::Linear{at(0, lean, 0), at(9, lean, turn)};
    motion.kind = kind;
    motion.coordinates = coordinates;
    verify::Move move;
    move.motion = &motion;
    move.is_move = true;
    verify::FindingLog log(setup);
    verify::judge_singular_pose(setup, move, log);
    verify::Verdict verdict;
    log.finish(verdict);
    for (const Finding& f : verdict.findings)
        EXPECT_NEAR(f.quantity->value, std::abs(turn), 1e-9);
    return verdict.findings.size();
}

TEST(SingularPose, IsAFarTurnOfAToolThatHardlyLeans) {
    EXPECT_EQ(singular(0.25, 170.0), 1U) << "0.498 degrees";
    EXPECT_EQ(singular(0.255, 170.0), 0U) << "0.508 degrees";
    EXPECT_EQ(singular(-0.25, 170.0), 1U);
    EXPECT_EQ(singular(0.25, 5.0), 0U);
    EXPECT_EQ(singular(0.25, 5.01), 1U);
    EXPECT_EQ(singular(0.25, -5.01), 1U);
    EXPECT_EQ(singular(0.0, 170.0), 0U) << "about the axis of the tool";
    EXPECT_EQ(singular(0.25, 170.0, gcode::MoveKind::Rapid), 0U);
    EXPECT_EQ(singular(0.25, 170.0, gcode::MoveKind::Feed, gcode::Coordinates::Axes), 0U);
}

TEST(WrongLengthOffset, IsMoreThanRounding) {
    // T1 is 80 mm long; it moves with the length in H2.
    const auto found = [](const std::string& length) {
        return findings_of(verdict_of("G21 G90 G10 L1 P1 Z80\nG10 L1 P2 Z" + length +
                                          "\nT1 M6\nG43 H2\nS1000 M3 F500 G0 X-50 Y0 Z5\nG1 Z-1\n"
                                          "G1 X0\n",
                                      not_simulated()),
                           "wrong-length-offset");
    };
    EXPECT_TRUE(found("80").empty());
    EXPECT_TRUE(found("80.0000005").empty());
    EXPECT_EQ(found("80.000005").size(), 1U);
    const auto shorter = found("79.5");
    ASSERT_EQ(shorter.size(), 1U);
    EXPECT_NEAR(shorter[0].quantity->value, 0.5, 1e-9);
    EXPECT_EQ(shorter[0].message, "T1 moves with the length of H2, which is another");
}

}  // namespace
}  // namespace ncsim::verify_test
