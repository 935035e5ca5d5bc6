// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over a program: path lengths and times of tools, regions of removed material, the balance of
// a ledger, and the texts of quantities.
#include "ncsim/verify/distances.h"
#include "ncsim/verify/finding.h"
#include "ncsim/verify/region.h"
#include "ncsim/verify/selection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::verify {
namespace {

using gcode::FeedMode;
using gcode::Length;
using gcode::MoveKind;

gcode::Position at(double x, double y, double z) {
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Motion line(gcode::Position from, gcode::Position to, MoveKind kind, double feed = 0.0) {
    gcode::Motion motion;
    motion.action = gcode::Linear{from, to};
    motion.kind = kind;
    motion.feed = feed;
    return motion;
}

TEST(Distances, OfEachKindOfMotion) {
    Distances sums;
    add(sums, line(at(0, 0, 0), at(3, 4, 0), MoveKind::Rapid));
    EXPECT_EQ(sums.rapid_mm, 5.0);
    EXPECT_EQ(sums.feed_mm, 0.0);
    add(sums, line(at(0, 0, 0), at(0, 0, 12), MoveKind::Feed, 240.0));
    EXPECT_EQ(sums.feed_mm, 12.0);
    EXPECT_NEAR(*sums.feed_seconds, 3.0, 1e-12);
    gcode::Motion inverse = line(at(0, 0, 0), at(7, 0, 0), MoveKind::Feed, 4.0);
    inverse.feed_mode = FeedMode::InverseTime;
    add(sums, inverse);
    EXPECT_NEAR(*sums.feed_seconds, 3.0 + 60.0 / 4.0, 1e-12);
    gcode::Motion turns = line(at(0, 0, 0), at(6, 0, 0), MoveKind::Feed, 0.1);
    turns.feed_mode = FeedMode::PerRevolution;
    turns.spindle_rpm = 600.0;
    add(sums, turns);
    EXPECT_NEAR(*sums.feed_seconds, 18.0 + 6.0, 1e-12);
    EXPECT_EQ(sums.feed_mm, 25.0);
    gcode::Motion pause;
    pause.action = gcode::Dwell{2.5};
    add(sums, pause);
    EXPECT_EQ(sums.dwell_seconds, 2.5);
    gcode::Motion change;
    change.action = gcode::ToolChange{2, {}};
    add(sums, change);
    add(sums, change);
    EXPECT_EQ(sums.tool_changes, 2U);
    gcode::Motion unknown = line(at(0, 0, 0), at(9, 0, 0), MoveKind::Rapid);
    unknown.known_start.x = false;
    add(sums, unknown);
    EXPECT_EQ(sums.rapid_mm, 5.0);
}

TEST(Distances, OfArcsAreWithinTheChordTolerance) {
    gcode::Arc arc;
    arc.from = at(10, 0, 0), arc.to = at(0, 10, 0);
    gcode::Motion motion;
    motion.action = arc;
    motion.kind = MoveKind::Feed;
    motion.feed = 100.0;
    Distances sums;
    add(sums, motion);
    EXPECT_LE(sums.feed_mm, 5.0 * std::numbers::pi);
    EXPECT_NEAR(sums.feed_mm, 5.0 * std::numbers::pi, 0.01);
}

TEST(Distances, HaveNoTimeWithoutAFeedOrASpeed) {
    Distances sums;
    add(sums, line(at(0, 0, 0), at(1, 0, 0), MoveKind::Feed, 0.0));
    EXPECT_FALSE(sums.feed_seconds);
    add(sums, line(at(0, 0, 0), at(1, 0, 0), MoveKind::Feed, 60.0));
    EXPECT_FALSE(sums.feed_seconds) << "unknown for good";
    EXPECT_EQ(sums.feed_mm, 2.0);
    Distances turning;
    gcode::Motion motion = line(at(0, 0, 0), at(1, 0, 0), MoveKind::Feed, 0.1);
    motion.feed_mode = FeedMode::PerRevolution;
    add(turning, motion);
    EXPECT_FALSE(turning.feed_seconds);
}

TEST(Distances, OfAllToolsAreTheSum) {
    const Distances one{1, 2, 3.0, 4, 5}, two{10, 20, 30.0, 40, 50};
    const Distances all = total({{1, one}, {2, two}});
    EXPECT_EQ(all.rapid_mm, 11.0);
    EXPECT_EQ(all.feed_mm, 22.0);
    EXPECT_EQ(all.feed_seconds, 33.0);
    EXPECT_EQ(all.dwell_seconds, 44.0);
    EXPECT_EQ(all.tool_changes, 55U);
    EXPECT_FALSE(total({{1, one}, {2, {1, 1, std::nullopt, 0, 0}}}).feed_seconds);
    EXPECT_EQ(total({}).feed_seconds, 0.0);
}

TEST(LineRanges, AreMergedIfTheyTouch) {
    using Ranges = std::vector<LineRange>;
    EXPECT_EQ(merged({}), Ranges{});
    EXPECT_EQ(merged({{0, 7, 9}, {0, 1, 2}, {0, 3, 3}}), (Ranges{{0, 1, 3}, {0, 7, 9}}));
    EXPECT_EQ(merged({{0, 1, 9}, {0, 2, 3}, {0, 10, 10}}), (Ranges{{0, 1, 10}}));
    EXPECT_EQ(merged({{0, 1, 2}, {0, 4, 5}}), (Ranges{{0, 1, 2}, {0, 4, 5}}));
    EXPECT_EQ(merged({{1, 3, 4}, {0, 1, 2}}), (Ranges{{0, 1, 2}, {1, 3, 4}}));
}

LedgerRow row(std::uint32_t line, double volume, double x) {
    LedgerRow row;
    row.line = line;
    row.removed_mm3 = volume;
    row.contact = {{x, 0, 0}, {x + 1, 1, 1}};
    return row;
}

TEST(Regions, AreRowsWhoseBoxesTouch) {
    Ledger ledger;
    // 0-1 and 2-3 are apart until 1-2 joins them; 9-10 is alone, and 20 removed nothing.
    ledger.rows = {row(1, 5, 0), row(2, 6, 2), row(3, 20, 9), row(4, 0, 20), row(6, 7, 1)};
    const std::vector<Region> regions = regions_of(ledger);
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[0].volume_mm3, 20.0);
    EXPECT_EQ(regions[0].lines, (std::vector<LineRange>{{0, 3, 3}}));
    EXPECT_EQ(regions[1].volume_mm3, 18.0);
    EXPECT_EQ(regions[1].box, (Box{{0, 0, 0}, {3, 1, 1}}));
    EXPECT_EQ(regions[1].lines, (std::vector<LineRange>{{0, 1, 2}, {0, 6, 6}}));
}

TEST(Ledger, IsBalancedIfNothingIsLost) {
    Ledger ledger;
    EXPECT_EQ(ledger.imbalance(), 0.0);
    ledger.stock_mm3 = 200.0, ledger.removed_mm3 = 50.0, ledger.rest_mm3 = 150.0;
    EXPECT_EQ(ledger.imbalance(), 0.0);
    ledger.rest_mm3 = 148.0;
    EXPECT_DOUBLE_EQ(ledger.imbalance(), 0.01);
    ledger.rest_mm3 = 152.0;
    EXPECT_DOUBLE_EQ(ledger.imbalance(), 0.01);
    LedgerRow slot = row(1, 30.0, 0.0);
    EXPECT_FALSE(slot.removal_rate());
    slot.seconds = 0.0;
    EXPECT_FALSE(slot.removal_rate());
    slot.seconds = 4.0;
    EXPECT_DOUBLE_EQ(*slot.removal_rate(), 450.0);
}

TEST(Quantity, IsANameANumberAndAUnit) {
    EXPECT_EQ(text_of({"removed", 12.5, "mm3"}), "removed 12.5 mm3");
    EXPECT_EQ(text_of({"pieces", 3, ""}), "pieces 3");
    EXPECT_EQ(text_of({"by", 1.0 / 3.0, "mm"}), "by 0.333333 mm");
    EXPECT_TRUE(less_is_worse({"apart", 1, "mm"}));
    EXPECT_FALSE(less_is_worse({"by", 1, "mm"}));
    EXPECT_EQ(name_of(Category::Program), "program");
    EXPECT_EQ(name_of(Category::Collision), "collision");
    EXPECT_EQ(name_of(Category::Travel), "travel");
    EXPECT_EQ(name_of(Category::Process), "process");
    EXPECT_EQ(name_of(Category::SetUp), "set-up");
    EXPECT_EQ(name_of(Severity::Note), "note");
    EXPECT_EQ(name_of(Severity::Warning), "warning");
    EXPECT_EQ(name_of(Severity::Error), "error");
}

TEST(SelectionOrigin, ReplacesTheOptionAlone) {
    Selection selection;
    selection.ignored = {{"air-cut", "--ignore"}, {"no-feed", "job.toml:3:1"}};
    selection.severities = {{"plunge", {Severity::Note, "--warn"}}};
    selection.set_origin("--ignore", "ncsim.toml:5:1");
    EXPECT_EQ(selection.ignored.at("air-cut"), "ncsim.toml:5:1");
    EXPECT_EQ(selection.ignored.at("no-feed"), "job.toml:3:1");
    EXPECT_EQ(selection.severities.at("plunge").by, "--warn");
    EXPECT_EQ(selection.accepted_by, "--accept");
    selection.set_origin("--warn", "ncsim.toml:6:1");
    selection.set_origin("--accept", "ncsim.toml:7:1");
    EXPECT_EQ(selection.severities.at("plunge").by, "ncsim.toml:6:1");
    EXPECT_EQ(selection.accepted_by, "ncsim.toml:7:1");
    EXPECT_FALSE(selection.includes("air-cut"));
    EXPECT_TRUE(selection.includes("plunge"));
}

}  // namespace
}  // namespace ncsim::verify
