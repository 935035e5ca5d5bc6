// SPDX-License-Identifier: GPL-3.0-or-later
#include "cycle_time.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/triangulate.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ncsim::verify_test {
namespace {

using verify::MotionPlanner;
using verify::PlannedMove;

PlannedMove along_x(double length, double speed, double acceleration) {
    PlannedMove move;
    move.length_mm = length;
    move.speed = speed;
    move.acceleration = acceleration;
    move.enters = move.leaves = {1, 0, 0};
    return move;
}

double seconds_of(const std::vector<PlannedMove>& moves, double deviation = 0.01) {
    double sum = 0.0;
    MotionPlanner planner(deviation, [&sum](std::size_t, double seconds) { sum += seconds; });
    for (const PlannedMove& move : moves)
        planner.add(move);
    planner.stop();
    return sum;
}

TEST(CycleTime, OfOneMoveIsATrapezoid) {
    // 100 mm at 50 mm/s and 500 mm/s²: 0.1 s of acceleration and of deceleration over 2.5 mm each,
    // 1.9 s between.
    EXPECT_NEAR(seconds_of({along_x(100, 50, 500)}), 2.1, 1e-12);
    // 5 mm give a triangular velocity profile with a peak of exactly 50 mm/s.
    EXPECT_NEAR(seconds_of({along_x(5, 50, 500)}), 0.2, 1e-12);
    EXPECT_NEAR(seconds_of({along_x(100, 50, 0)}), 2.0, 1e-12);
}

TEST(CycleTime, OfNoWayAndOfNoSpeedIsNothing) {
    EXPECT_EQ(verify::trapezoid_seconds(0.0, 0.0, 0.0, 50.0, 500.0), 0.0);
    EXPECT_EQ(verify::trapezoid_seconds(0.0, 5.0, 9.0, 50.0, 500.0), 0.0);
    EXPECT_EQ(verify::trapezoid_seconds(100.0, 0.0, 0.0, 0.0, 500.0), 0.0);
    EXPECT_EQ(verify::trapezoid_seconds(100.0, 0.0, 0.0, 0.0, 0.0), 0.0);
    // Acceleration from 10 to 30 mm/s over 8 mm at 50 mm/s2.
    EXPECT_NEAR(verify::trapezoid_seconds(8.0, 10.0, 30.0, 30.0, 50.0), 0.4, 1e-12);
}

TEST(CycleTime, OfAMoveInPiecesIsThatOfTheWhole) {
    const std::vector<PlannedMove> pieces(1000, along_x(0.1, 50, 500));
    EXPECT_NEAR(seconds_of(pieces), 2.1, 1e-9);
}

TEST(CycleTime, StopsWhereTheWayReverses) {
    PlannedMove back = along_x(100, 50, 500);
    back.enters = back.leaves = {-1, 0, 0};
    EXPECT_NEAR(seconds_of({along_x(100, 50, 500), back}), 4.2, 1e-12);
    PlannedMove rapid = along_x(100, 50, 500);
    rapid.stops = true;
    EXPECT_NEAR(seconds_of({along_x(100, 50, 500), rapid}), 4.2, 1e-12);
}

TEST(CycleTime, SlowsDownForACornerByTheJunctionDeviation) {
    PlannedMove up = along_x(100, 50, 500);
    up.enters = up.leaves = {0, 1, 0};
    const double s = std::sqrt(0.5);
    const double v = std::sqrt(500 * 0.01 * s / (1 - s));
    const double half = verify::trapezoid_seconds(100, 0, v, 50, 500);
    EXPECT_NEAR(seconds_of({along_x(100, 50, 500), up}), 2 * half, 1e-12);
    EXPECT_LT(2 * half, 4.2);
    EXPECT_GT(2 * half, 4.0);
}

TEST(CycleTime, LimitsAreThoseOfTheAxesThatMove) {
    verify::MachineDescription machine;
    machine.rapid = {6000, 3000, std::nullopt};
    machine.acceleration = {1000, 400, std::nullopt};
    EXPECT_DOUBLE_EQ(*verify::rapid_speed_along(machine, {1, 0, 0}), 100);
    EXPECT_DOUBLE_EQ(*verify::rapid_speed_along(machine, {0.6, 0.8, 0}), 62.5);
    EXPECT_DOUBLE_EQ(verify::acceleration_along(machine, {0.6, 0.8, 0}), 500);
    EXPECT_FALSE(verify::rapid_speed_along(machine, {0.6, 0, 0.8}));
}

TEST(Ledger, BalancesAndNamesWhatEachBlockTookAndHowLong) {
    verify::Setup setup = plain_setup();
    setup.ledger = true;
    setup.machine.rapid = {6000, 6000, 6000};
    setup.machine.tool_change_seconds = 4.0;
    const auto verdict = verdict_of(
        "G21 G90 T1 M6 S1000 M3 G0 X-30 Y0 Z5\nG0 Z-2\nG1 X30 F600\nG4 P1.5\nG1 Z-4\nG1 X-30\n",
        setup);
    const verify::Ledger& ledger = verdict.ledger;
    ASSERT_EQ(ledger.rows.size(), 6U);
    const auto& slot = ledger.rows[2];
    EXPECT_EQ(slot.line, 3U);
    EXPECT_DOUBLE_EQ(slot.removed_mm3, 800.0);
    EXPECT_DOUBLE_EQ(slot.length_mm, 60.0);
    EXPECT_NEAR(*slot.seconds, 6.0, 1e-12);
    EXPECT_NEAR(*slot.removal_rate(), 8000.0, 1e-9);
    EXPECT_EQ(slot.contact, (Box{{-20, -5, -2}, {20, 5, 0}}));
    EXPECT_NEAR(*ledger.rows[3].seconds, 1.5, 1e-12);
    EXPECT_DOUBLE_EQ(ledger.rows[5].removed_mm3, 800.0);
    EXPECT_TRUE(ledger.measured);
    EXPECT_DOUBLE_EQ(ledger.stock_mm3, 12000.0);
    EXPECT_DOUBLE_EQ(ledger.rest_mm3, 10400.0);
    EXPECT_LT(ledger.imbalance(), 1e-12);
    EXPECT_NEAR(*ledger.feed_seconds, 6.0 + 0.2 + 6.0, 1e-12);
    EXPECT_NEAR(*ledger.other_seconds, 5.5, 1e-12);
    EXPECT_NEAR(*ledger.rapid_seconds, 7.0 / 100, 1e-12) << "the first move has no known start";
}

TEST(Ledger, AnArcIsAsFastAsItsRadiusPermits) {
    // Radius 4, away from the zero: sqrt(100 * 4) = 20 mm/s; in each plane.
    verify::Setup setup = plain_setup();
    setup.ledger = true;
    setup.machine.acceleration = {100, 100, 100};
    for (const char* arc : {"G17\nG3 X-26 Y6 I4 J0", "G17\nG2 X-30 Y10 I0 J4",
                            "G18\nG2 X-30 Z9 I0 K4", "G19\nG3 Y10 Z5 J-4 K0"}) {
        const auto verdict = verdict_of(
            "G21 G90 T1 M6 S1000 M3 F6000 G0 X-34 Y6 Z5\n" + std::string(arc) + "\n", setup);
        const auto& row = verdict.ledger.rows.back();
        EXPECT_NEAR(*row.seconds, verify::trapezoid_seconds(row.length_mm, 0, 0, 20, 100), 0.002)
            << arc;
    }
}

// Volumes are booked at the end or, if a rule needs the volume of each motion, before the next
// motion.
TEST(Ledger, IsTheSameWheneverItIsMeasured) {
    const std::string program =
        "G21 G90 G17 T1 M6 S1000 M3 G0 X-30 Y0 Z5\nG0 Z-2\nG1 X30 F600\n"
        "G2 X20 Y10 I-5 J5\nG3 X-18 Y4 I-20 J-20 Z-3\nG1 X-18 Y4\nG1 X30 Y0\n"
        "G0 Z-4\nG0 X0\nG1 X-25 Y-10\nG1 X30 Y0 Z5\nG2 X30 Y0 I-30 J0 Z-6\nG1 X-30\nX30\n";
    for (const bool is_ball : {false, true}) {
        SCOPED_TRACE(is_ball);
        verify::Setup setup = plain_setup();
        setup.ledger = true;
        if (is_ball) setup.tools.at(1).tool = toolpath::ball_end_mill(10.0, 30.0);
        const verify::Ledger late = verdict_of(program, setup).ledger;
        setup.tools.at(1).max_removal_rate = 1e12;
        setup.air_cuts = true;
        const verify::Ledger soon = verdict_of(program, setup).ledger;
        ASSERT_EQ(late.rows.size(), soon.rows.size());
        for (std::size_t i = 0; i < late.rows.size(); ++i) {
            SCOPED_TRACE(late.rows[i].line);
            EXPECT_NEAR(late.rows[i].removed_mm3, soon.rows[i].removed_mm3, 1e-9);
            EXPECT_EQ(late.rows[i].seconds, soon.rows[i].seconds);
            EXPECT_EQ(late.rows[i].contact.is_empty(), soon.rows[i].contact.is_empty());
        }
        EXPECT_TRUE(late.measured && soon.measured);
        EXPECT_NEAR(late.removed_mm3, soon.removed_mm3, 1e-9);
        EXPECT_LT(late.imbalance(), 1e-12);
        EXPECT_GT(late.air_mm, 50.0);
        EXPECT_NEAR(late.air_mm, soon.air_mm, 1e-9);
    }
}

TEST(Ledger, HasNoTimeWhereARateIsNotTold) {
    verify::Setup setup = plain_setup();
    setup.ledger = true;
    const auto verdict =
        verdict_of("G21 G90 T1 M6 S1000 M3 G0 X-30 Y0 Z5\nG0 Z-2\nG1 X30 F600\n", setup);
    EXPECT_FALSE(verdict.ledger.rapid_seconds);
    EXPECT_FALSE(verdict.ledger.other_seconds);
    EXPECT_TRUE(verdict.ledger.feed_seconds);
    EXPECT_FALSE(verdict.ledger.rows[1].seconds);
}

// A slot with a round end against the formula: 6 mm wide, 25 mm long, 5 mm deep, in a block of 40 x
// 40 x 10 mm. The volume left is 15,108.63 mm³ within the chord bound, and the surface is closed.
TEST(Ledger, SlotOfAFlatEndMillIsWithinTheChordBound) {
    const Box block{{0, 0, -10}, {40, 40, 0}};
    const cda::Lattice lattice = cda::Lattice::for_stock(block);
    cda::TreeCda part(cda::box_cell(lattice.round(block.min), lattice.round(block.max), lattice),
                      lattice);
    verify::Setup setup;
    setup.ledger = true;
    setup.accuracy.tolerance_mm = 0.001;
    setup.tools[1].tool = toolpath::flat_end_mill(6.0, 20.0);
    toolpath::Walk walk(lattice, block, {setup.accuracy});
    const double error = walk.add_tool(1, setup.tools[1].tool).error_mm();
    verify::Verifier verifier(setup, block, lattice);
    const gcode::SourceFile program{
        "slot.nc", "G21 G90 T1 M6 S1 M3 F100\nG0 X7.5 Y20 Z5\nG1 Z-5\nG1 X32.5\nG0 Z5\n"};
    ASSERT_TRUE(verifier.needs_account());
    part.track_removal();
    std::uint32_t motions = 0;
    const auto result = gcode::interpret(program, {}, [&](const gcode::Motion& m) {
        take(m, cda::Origin{++motions}, verifier, walk, &part);
    });
    const verify::Ledger ledger = verifier.finish(result, &part, 40.0 * 40.0 * 10.0).ledger;
    const double exact = 40 * 40 * 10 - 5 * (25 * 6 + 3.14159265358979324 * 9);
    EXPECT_NEAR(exact, 15108.63, 0.005);
    EXPECT_LE(ledger.rest_mm3, exact);
    EXPECT_GE(ledger.rest_mm3, exact - 5 * 2 * 3.1416 * (3 + error) * error);
    EXPECT_NEAR(ledger.rest_mm3, exact, 0.1);
    EXPECT_LT(ledger.imbalance(), 1e-12);
    EXPECT_TRUE(cda::check(cda::triangulate(part.boundary())).is_closed());
}

}  // namespace
}  // namespace ncsim::verify_test
