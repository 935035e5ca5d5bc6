// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spindle, feed, depth, engagement and removal. Each rule has a program that violates the rule at a
// known line by a known amount, a program that just keeps the rule, and a program for which the
// rule cannot be checked.
#include "ncsim/verify/rule.h"

#include "verify/expected.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace ncsim::verify_test {
namespace {

using verify::Finding;
using verify::Severity;

TEST(SpindleOff, IsFoundWhereTheToolMeetsMaterial) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nM5\nG1 X-25\nG1 X30\n");
    const Finding f = only(verdict, "spindle-off");
    expect_at(f, 5, 800.0);  // line 4 ends where the tool touches the block
}

TEST(SpindleOff, IsFoundWithoutASpeed) {
    const auto verdict = verdict_of("G21 G90 T1 M6 M3 F500 G0 X-30 Y0 Z-2\nG1 X30\n");
    EXPECT_NE(only(verdict, "spindle-off").message.find("no speed"), std::string::npos);
}

TEST(SpindleOff, IsToldOfAFewCutsEachTimeItIsOff) {
    const auto cuts = [](int count) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += "G1 Z" + std::to_string(-0.1 * (i + 1)) + (i % 2 == 0 ? " X30\n" : " X-30\n");
        return text;
    };
    const auto verdict =
        verdict_of(kStart + "M5\n" + cuts(50) + "M3\nG1 X0\nG0 Z5\nY5\nM5\n" + cuts(3));
    const auto found = findings_of(verdict, "spindle-off");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].count, 20U);
    EXPECT_TRUE(found[0].goes_on);
    EXPECT_EQ(found[0].quantity->name, "removed at least");
    EXPECT_EQ(found[1].count, 2U);
    EXPECT_FALSE(found[1].goes_on);
}

TEST(SpindleOff, IsFoundAfterCutsThatSomebodyAccepts) {
    std::string program = kStart +
                          "M5\nG0 Z-1\nO100 REPEAT [30]\n(ncsim: ignore spindle-off)\n"
                          "G91 G1 Z-0.1 X2 G90\nO100 ENDREPEAT\nG1 X30\nM2\n";
    const auto found = findings_of(verdict_of(program), "spindle-off");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[0].suppressed);
    EXPECT_FALSE(found[1].suppressed);
}

TEST(SpindleOff, IsNotFoundInTheAirOrWithTheSpindleOn) {
    EXPECT_TRUE(findings_of(verdict_of(kStart + "M5\nG1 Z0\nG1 X30\n"), "spindle-off").empty());
    EXPECT_TRUE(findings_of(verdict_of(kStart + "G0 Z-2\nG1 X30\n"), "spindle-off").empty());
}

TEST(SpindleReversed, IsFoundForTheHandOfTheTool) {
    const std::string program =
        "G21 G90 T1 M6 S1000 M4 F500 G0 X-30 Y0 Z-2\nG1 X30\nM3\nG1 Y5 F100\n";
    expect_at(only(verdict_of(program), "spindle-reversed"), 2, 800.0);
    verify::Setup setup = plain_setup();
    setup.tools.at(1).left_hand = true;
    const std::string left =
        "G21 G90 T1 M6 S1000 M4 F500 G0 X-30 Y0 Z-2\nG1 X30\nG0 Z5\nG0 X-30 Y5\nZ-2\n"
        "M3\nG1 X30\n";
    expect_at(only(verdict_of(left, setup), "spindle-reversed"), 7, 400.0);
}

TEST(SpindleLimit, IsFoundBeyondTheTighterLimit) {
    verify::Setup setup = plain_setup();
    setup.machine.max_rpm = 8000;
    setup.tools.at(1).max_rpm = 1200;
    setup.machine.min_rpm = 100;
    const std::string program = "S1200\nG1 Z4\nS1201\nG1 Z3\nG1 Z2\nS100\nG1 Z1\nS99\nG1 Z0\n";
    const auto found = findings_of(verdict_of(kStart + program, setup), "spindle-limit");
    ASSERT_EQ(found.size(), 2U);
    expect_at(found[0], 5, 1201);
    EXPECT_EQ(found[0].count, 2U);
    EXPECT_EQ(found[0].message, "spindle speed above the tool's limit of 1200 rpm");
    expect_at(found[1], 10, 99);
}

TEST(SpindleLimit, IsSkippedWithoutALimit) {
    EXPECT_NE(skipped_because(verdict_of(kStart), "spindle-limit"), "");
}

TEST(NoFeed, IsFoundUntilThereIsOne) {
    const auto verdict =
        verdict_of("G21 G90 T1 M6 S1000 M3 G0 X-30 Y0 Z5\nG1 Z4\nG0 Z5\nG1 Z2\nG1 Z0 F100\n");
    const Finding f = only(verdict, "no-feed");
    expect_at(f, 2, 4.0);
    EXPECT_EQ(f.count, 2U);
    EXPECT_EQ(f.last.span.line, 4U);
    EXPECT_TRUE(findings_of(verdict, "program-fault").empty() ||
                findings_of(verdict, "program-fault")[0].code != "feed-missing");
}

TEST(FeedLimit, IsFoundBeyondIt) {
    verify::Setup setup = plain_setup();
    setup.machine.max_feed = 1000;
    const auto verdict = verdict_of(kStart + "G1 Z4 F1000\nG1 Z3 F1000.5\nG0 Z0\n", setup);
    expect_at(only(verdict, "feed-limit"), 3, 1000.5);
    EXPECT_NE(skipped_because(verdict_of(kStart), "feed-limit"), "");
}

TEST(FeedLimit, ReadsInverseTimeAndFeedPerRevolution) {
    verify::Setup setup = plain_setup();
    setup.machine.max_feed = 1000;
    // 60 mm in 0.1 min; 1.5 mm in each of 1000 revolutions per minute.
    const auto verdict =
        verdict_of(kStart + "G93 G1 X30 F10\nG1 X-30 F20\nG95 G1 X30 F1.5\n", setup);
    const auto found = findings_of(verdict, "feed-limit");
    ASSERT_EQ(found.size(), 1U);
    expect_at(found[0], 3, 1500.0);
    EXPECT_EQ(found[0].count, 2U);
}

TEST(DepthLimit, IsFoundWithTheDepth) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).max_depth = 3.0;
    const auto verdict = verdict_of(kStart + "G0 Z-3\nG1 X30\nG0 Z5\nX-30\nZ-7.5\nG1 X30\n", setup);
    // 4.5 mm below the first slot
    expect_at(only(verdict, "depth-limit"), 7, 4.5);
    EXPECT_TRUE(findings_of(verdict_of(kStart + "G0 Z-3\nG1 X30\n", setup), "depth-limit").empty());
    EXPECT_NE(skipped_because(verdict_of(kStart), "depth-limit"), "");
}

TEST(DepthLimit, DoesNotMindDrilling) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).max_depth = 3.0;
    EXPECT_TRUE(findings_of(verdict_of(kStart + "G0 X0\nG1 Z-9\n", setup), "depth-limit").empty());
}

TEST(DepthLimit, IsMeasuredWithoutCutting) {
    // The cylinder above the depth limit must not count with the ball, which would give 680.9 mm³
    // instead of 449.6 mm³.
    verify::Setup setup = plain_setup();
    setup.ledger = true;
    setup.tools.at(1).tool = toolpath::ball_end_mill(10.0, 20.0);
    const std::string program = kStart + "G0 Z-1\nG1 X30\nG0 Z5\nX-30\nZ-2.5\nG1 X30\n";
    const auto rest_of = [&] { return verdict_of(program, setup).ledger.rest_mm3; };
    const double rest = rest_of();
    EXPECT_LT(rest, 12000.0 - 300.0);
    for (const double limit : {0.3, 1.0, 2.0}) {
        setup.tools.at(1).max_depth = limit;
        EXPECT_EQ(rest_of(), rest) << limit;
    }
}

TEST(EngagementAndRemovalRate, AreFoundWithTheirNumbers) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).max_engagement = 13.0;
    setup.tools.at(1).max_removal_rate = 6000.0;
    // 800 mm³ over 60 mm at 500 mm/min.
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG1 X30\n", setup);
    expect_at(only(verdict, "engagement-limit"), 3, 800.0 / 60);
    expect_at(only(verdict, "removal-rate"), 3, 800.0 / 60 * 500);
    const auto slow = verdict_of(kStart + "G0 Z-1.9\nG1 X30 F450\n", setup);
    EXPECT_TRUE(findings_of(slow, "engagement-limit").empty());
    EXPECT_TRUE(findings_of(slow, "removal-rate").empty());
    EXPECT_NE(skipped_because(verdict_of(kStart), "engagement-limit"), "");
    EXPECT_NE(skipped_because(verdict_of(kStart), "removal-rate"), "");
}

TEST(AirCut, TellsTheShareAndTheLines) {
    verify::Setup setup = plain_setup();
    setup.air_cuts = true;
    const auto verdict = verdict_of(kStart + "G1 Z-2\nG1 X30\nG1 Y20\nG1 Y30\n", setup);
    const Finding f = only(verdict, "air-cut");
    EXPECT_EQ(f.severity, Severity::Note);
    EXPECT_EQ(f.message, "3 of 4 feed moves remove nothing, at lines 2, 4-5");
    expect_at(f, 2, 100.0 * 37 / 97);
    const auto busy = verdict_of(kStart + "G0 Z-2\nG1 X30\n", setup);
    EXPECT_TRUE(findings_of(busy, "air-cut").empty());
    EXPECT_NE(skipped_because(verdict_of(kStart, not_simulated()), "air-cut"), "");
}

/// Without the other rules a guessed stock is a doubt about air cuts, too, if they are looked for.
TEST(AirCut, OnAGuessedStockIsNotProven) {
    const auto reasons = [](const verify::Setup& setup) {
        const auto verdict = verdict_of(kStart + "G1 Z-2\nG1 X30\nG1 Y20\n", setup);
        std::set<std::string> all;
        for (const verify::Doubt& doubt : verdict.doubts)
            all.insert(std::string(doubt.reason));
        return all;
    };
    verify::Setup setup = plain_setup();
    for (const verify::RuleInfo& rule : verify::rules()) {
        if (rule.id != "air-cut") setup.selection.ignored[std::string(rule.id)] = "--select";
    }
    setup.stock_assumption = "derived";
    EXPECT_FALSE(reasons(setup).contains("stock-guess")) << "no air cuts are looked for";
    setup.air_cuts = true;
    EXPECT_TRUE(reasons(setup).contains("stock-guess"));
    setup.stock_assumption.clear();
    EXPECT_FALSE(reasons(setup).contains("stock-guess"));
}

/// With the severity of an error, the finding gives a second doubt: the error rests on a guess.
TEST(AirCut, AsAnErrorRestsOnTheStock) {
    verify::Setup setup = plain_setup();
    setup.air_cuts = true;
    setup.stock_assumption = "derived";
    const auto errors_in_doubt = [&] {
        const auto verdict = verdict_of(kStart + "G1 Z-2\nG1 X30\nG1 Y20\n", setup);
        return std::ranges::count_if(verdict.doubts, [](const verify::Doubt& doubt) {
            return doubt.message.starts_with("an error rests on it: 2 of 3 feed moves");
        });
    };
    EXPECT_EQ(errors_in_doubt(), 0) << "a note";
    setup.selection.severities["air-cut"] = {Severity::Error, "--severity"};
    EXPECT_EQ(errors_in_doubt(), 1);
    setup.stock_assumption.clear();
    EXPECT_EQ(errors_in_doubt(), 0);
}

}  // namespace
}  // namespace ncsim::verify_test
