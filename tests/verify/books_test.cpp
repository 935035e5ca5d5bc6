// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clock and ledger, move by move, with times and volumes on paper; and the counter of cuts with an
// idle spindle.
#include "clock.h"
#include "idle_spindle.h"
#include "ledger_book.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::verify {
namespace {

using gcode::Length;
using gcode::MoveKind;

gcode::Motion line(double x, double y, double z, MoveKind kind, double feed = 0.0) {
    gcode::Motion motion;
    gcode::Position to;
    to.x = Length::from_mm(x), to.y = Length::from_mm(y), to.z = Length::from_mm(z);
    motion.action = gcode::Linear{{}, to};
    motion.kind = kind;
    motion.feed = feed;
    return motion;
}

Move move_of(const gcode::Motion& motion) {
    Move move;
    move.motion = &motion;
    move.is_move = true;
    const gcode::Position& to = *gcode::end_of(motion);
    const Vec3 way{to.x.mm(), to.y.mm(), to.z.mm()};
    move.length_mm = norm(way);
    move.enters = move.leaves = normalized(way);
    return move;
}

MachineDescription machine() {
    MachineDescription machine;
    machine.rapid = {6000.0, 3000.0, 1200.0};
    machine.tool_change_seconds = 7.0;
    return machine;
}

/// Ledger after the moves of `take`, with four rows.
template <class Take>
Ledger after(const MachineDescription& machine, Take take) {
    Clock clock(machine);
    take(clock);
    Ledger ledger;
    ledger.rows.resize(4);
    clock.finish(ledger);
    return ledger;
}

TEST(Clock, RapidsHaveTheRateOfTheAxisThatLimits) {
    // 30 and 40 mm: X at 100 mm/s would take 0.3 s, Y at 50 mm/s takes 0.8 s.
    const gcode::Motion slant = line(30, 40, 0, MoveKind::Rapid);
    const gcode::Motion up = line(0, 0, 10, MoveKind::Rapid);
    const Ledger ledger = after(machine(), [&](Clock& clock) {
        clock.take(move_of(slant), 0);
        clock.take(move_of(up), 1);
        clock.take(move_of(up), 1);
    });
    EXPECT_NEAR(*ledger.rapid_seconds, 0.8 + 0.5 + 0.5, 1e-9);
    EXPECT_NEAR(*ledger.rows[0].seconds, 0.8, 1e-9);
    EXPECT_NEAR(*ledger.rows[1].seconds, 1.0, 1e-9);
    EXPECT_EQ(ledger.feed_seconds, 0.0);
}

TEST(Clock, FeedsAreAtMostThoseOfTheMachine) {
    MachineDescription limited = machine();
    limited.max_feed = 600.0;
    for (const auto& [feed, seconds] : {std::pair{300.0, 6.0}, {600.0, 3.0}, {1200.0, 3.0}}) {
        const gcode::Motion cut = line(30, 0, 0, MoveKind::Feed, feed);
        const Ledger ledger = after(limited, [&](Clock& clock) { clock.take(move_of(cut), 2); });
        EXPECT_NEAR(*ledger.feed_seconds, seconds, 1e-9) << feed;
        EXPECT_NEAR(*ledger.rows[2].seconds, seconds, 1e-9);
        EXPECT_EQ(ledger.rapid_seconds, 0.0);
    }
}

TEST(Clock, ArcsAreAtMostAsFastAsTheirRadiusPermits) {
    // 400 mm/s² on a radius of 4 mm: 40 mm/s. From rest to rest with 400 mm/s² along 104 mm: 0.1 s
    // up and down over 2 mm each, and 100 mm at 40 mm/s.
    MachineDescription fast = machine();
    fast.acceleration = {400.0, 400.0, 400.0};
    const gcode::Motion cut = line(104, 0, 0, MoveKind::Feed, 6000.0);
    Move move = move_of(cut);
    move.radius_mm = 4.0;
    const Ledger ledger = after(fast, [&](Clock& clock) { clock.take(move, 0); });
    EXPECT_NEAR(*ledger.feed_seconds, 0.2 + 2.5, 1e-9);
    // The slower axis at either end limits the acceleration: 100 instead of 400 mm/s².
    fast.acceleration[1] = 100.0;
    for (const bool first : {false, true}) {
        move.radius_mm = 0.0;
        move.enters = first ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
        move.leaves = first ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Ledger slow = after(fast, [&](Clock& clock) { clock.take(move, 0); });
        EXPECT_NEAR(*slow.feed_seconds, 1.0 + 1.04, 1e-9);
    }
}

TEST(Clock, UnknownPartsLeaveTheirSumsUnknown) {
    const gcode::Motion no_feed = line(30, 0, 0, MoveKind::Feed);
    const gcode::Motion cut = line(30, 0, 0, MoveKind::Feed, 600.0);
    Ledger ledger = after(machine(), [&](Clock& clock) {
        clock.take(move_of(cut), 0);
        clock.take(move_of(no_feed), 1);
        clock.take(move_of(cut), 1);
    });
    EXPECT_FALSE(ledger.feed_seconds);
    EXPECT_EQ(ledger.rapid_seconds, 0.0);
    EXPECT_NEAR(*ledger.rows[0].seconds, 3.0, 1e-9);
    EXPECT_FALSE(ledger.rows[1].seconds) << "unknown for good";
    MachineDescription slow = machine();
    slow.rapid[1].reset();
    slow.tool_change_seconds.reset();
    const gcode::Motion slant = line(30, 40, 0, MoveKind::Rapid);
    gcode::Motion change;
    change.action = gcode::ToolChange{2, {}};
    ledger = after(slow, [&](Clock& clock) {
        clock.take(move_of(slant), 0);
        clock.rest(change, 1);
    });
    EXPECT_FALSE(ledger.rapid_seconds);
    EXPECT_FALSE(ledger.other_seconds);
    EXPECT_EQ(ledger.feed_seconds, 0.0);
}

TEST(Clock, DwellsAndToolChangesAreTheRest) {
    gcode::Motion pause, change;
    pause.action = gcode::Dwell{2.5};
    change.action = gcode::ToolChange{2, {}};
    const Ledger ledger = after(machine(), [&](Clock& clock) {
        clock.rest(pause, 3);
        clock.rest(change, 3);
        clock.rest(change, 3);
    });
    EXPECT_EQ(ledger.other_seconds, 16.5);
    EXPECT_EQ(ledger.rows[3].seconds, 2.5);
    EXPECT_EQ(ledger.rows[0].seconds, 0.0);
}

TEST(Clock, AMoveWithoutLengthHasATimeIfItsStartIsKnown) {
    gcode::Motion nowhere = line(0, 0, 0, MoveKind::Rapid);
    Ledger ledger = after(machine(), [&](Clock& clock) { clock.take(move_of(nowhere), 0); });
    EXPECT_EQ(ledger.rapid_seconds, 0.0);
    nowhere.known_start.x = false;
    ledger = after(machine(), [&](Clock& clock) { clock.take(move_of(nowhere), 0); });
    EXPECT_FALSE(ledger.rows[0].seconds);
    EXPECT_EQ(ledger.rapid_seconds, 0.0) << "sums contain the remaining moves";
}

// --- Ledger ---

Move entry(const gcode::Motion& motion, std::uint64_t number, double removed) {
    Move move = move_of(motion);
    move.number = number;
    move.removed_mm3 = removed;
    move.contact = {{0, 0, 0}, {removed, 1, 1}};
    return move;
}

TEST(LedgerBook, SuccessiveMotionsOfABlockAreARow) {
    Ledger ledger;
    LedgerBook book(ledger, {{0, 0, 0}, {10, 10, 10}});
    EXPECT_EQ(book.row(), 0U);
    gcode::Motion down = line(0, 0, 3, MoveKind::Rapid), cut = line(0, 4, 0, MoveKind::Feed, 1.0);
    down.span.line = cut.span.line = 7;
    book.enter(entry(down, 1, 0.0), false);
    book.enter(entry(cut, 2, 5.0), false);
    ASSERT_EQ(ledger.rows.size(), 1U);
    EXPECT_EQ(ledger.rows[0].kind, MoveKind::Feed) << "a feed move among rapids";
    EXPECT_EQ(ledger.rows[0].length_mm, 7.0);
    EXPECT_EQ(ledger.rows[0].removed_mm3, 5.0);
    EXPECT_EQ(ledger.rows[0].first_motion, 1U);
    EXPECT_EQ(ledger.rows[0].last_motion, 2U);
    EXPECT_EQ(ledger.rows[0].contact.max.x, 5.0);
    book.enter(entry(cut, 4, 1.0), false);
    EXPECT_EQ(ledger.rows.size(), 2U) << "executed again";
    cut.tool = 2;
    book.enter(entry(cut, 5, 1.0), false);
    EXPECT_EQ(ledger.rows.size(), 3U);
    cut.file = 1;
    book.enter(entry(cut, 6, 1.0), false);
    EXPECT_EQ(ledger.rows.size(), 4U);
    cut.span.line = 8;
    book.enter(entry(cut, 7, 1.0), false);
    EXPECT_EQ(ledger.rows.size(), 5U);
    EXPECT_EQ(book.row(), 4U);
}

TEST(LedgerBook, TheAccountGivesVolumesAndAirLater) {
    Ledger ledger;
    LedgerBook book(ledger, {{0, 0, 0}, {10, 10, 10}});
    std::vector<gcode::Motion> motions;
    motions.reserve(4);
    for (std::uint32_t i = 1; i <= 4; ++i) {
        motions.push_back(line(10.0 * i, 0, 0, i == 4 ? MoveKind::Rapid : MoveKind::Feed, 1.0));
        motions.back().span.line = i;
    }
    std::vector<cda::Cell> cells(1);
    const toolpath::Pose pose{};
    for (std::uint32_t i = 1; i <= 4; ++i) {
        book.begin();
        cells[0].origin = cda::Origin{i};
        cells[0].bounds = {{-5, 2, 3}, {4, 6, 8}};  // 4 x 4 x 5 mm within the stock
        book.note_cells({pose, pose, cells, {}, {}, {}, true, {}, {}}, 1.0);
        book.enter(entry(motions[i - 1], i, 99.0), true);
    }
    // The slivers of an upright tool are 2^-24 of the extent of the cells, over their surface.
    const double sliver = 2.0 * 0x1p-24 * std::sqrt(16 + 16 + 25.0) * (16 + 20 + 20);
    const cda::RemovalByMotion account{{cda::Origin{1}, {8.0, {{-9, 0, 0}, {5, 5, 5}}}},
                                       {cda::Origin{2}, {0.999 * sliver, {{0, 0, 0}, {1, 1, 1}}}},
                                       {cda::Origin{3}, {1.001 * sliver, {{0, 0, 0}, {1, 1, 1}}}}};
    book.close(account, true);
    EXPECT_EQ(ledger.rows[0].removed_mm3, 8.0);
    EXPECT_EQ(ledger.rows[0].contact, (Box{{0, 0, 0}, {5, 5, 5}}));
    EXPECT_EQ(ledger.rows[1].removed_mm3, 0.999 * sliver);
    EXPECT_EQ(ledger.rows[3].removed_mm3, 0.0);
    EXPECT_NEAR(ledger.removed_mm3, 8.0 + 2.0 * sliver, 1e-9 * sliver);
    EXPECT_NEAR(ledger.air_mm, 20.0, 1e-9) << "the second move alone; the fourth is a rapid";
    ledger.air_mm = 0.0;
    book.close({}, false);
    EXPECT_EQ(ledger.air_mm, 0.0);
    book.close({}, true);
    EXPECT_NEAR(ledger.air_mm, 10.0 + 20.0 + 30.0, 1e-9);
}

// --- Idle spindle ---

TEST(IdleSpindle, CountsTwentyCutsOfEachState) {
    IdleSpindle spindle;
    gcode::Motion motion;
    motion.tool = 1;
    const auto cut = [&](int times) {
        for (int i = 0; i < times; ++i) {
            spindle.begin(motion);
            spindle.count_cut();
        }
    };
    cut(19);
    EXPECT_FALSE(spindle.is_specified());
    cut(1);
    EXPECT_TRUE(spindle.is_specified());
    for (int change = 0; change < 4; ++change) {
        if (change == 0) motion.tool = 2;
        if (change == 1) motion.spindle = gcode::SpindleTurning::Counterclockwise;
        if (change == 2) motion.spindle_rpm = 5.0;
        if (change == 3) motion.spindle_in_doubt = true;
        spindle.begin(motion);
        EXPECT_FALSE(spindle.is_specified()) << change;
        cut(20);
        EXPECT_TRUE(spindle.is_specified());
    }
}

}  // namespace
}  // namespace ncsim::verify
