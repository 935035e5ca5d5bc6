// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rapid moves that meet material, and slivers that do not count. Each rule has a program that
// violates the rule at a known line by a known amount, a program that just keeps the rule, and a
// program for which the rule cannot be checked.
#include "verify/expected.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace ncsim::verify_test {
namespace {

using verify::Certainty;
using verify::Finding;
using verify::Severity;

TEST(RapidInMaterial, IsFoundAtItsLineWithTheVolumeItTakes) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X30\nG0 Z5\n");
    const Finding f = only(verdict, "rapid-in-material");
    expect_at(f, 3, 800.0);  // 10 x 2 over 40 mm
    EXPECT_EQ(f.severity, Severity::Error);
    EXPECT_EQ(f.certainty, Certainty::Certain);
    EXPECT_EQ(f.tool, 1);
    EXPECT_EQ(f.box, (Box{{-20, -5, -2}, {20, 5, 0}}));
}

// After a certain finding, only steps that could extend its place are examined. The result must
// equal a run that examines all steps because volumes are measured.
TEST(RapidInMaterial, IsToldWhereverItIsThoughNotAllStepsAreLookedAt) {
    const std::string program = kStart + "G0 Z-3\nG0 X30 A60\nG0 X-30 Y3 A0\n";
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::flat_end_mill(10.0, 40.0);
    const auto quick = findings_of(verdict_of(program, setup), "rapid-in-material");
    setup.tools.at(1).max_engagement = 1000.0;
    const auto all = findings_of(verdict_of(program, setup), "rapid-in-material");
    ASSERT_FALSE(all.empty());
    ASSERT_EQ(quick.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(quick[i].box, all[i].box) << i;
        EXPECT_EQ(quick[i].point, all[i].point) << i;
        EXPECT_EQ(quick[i].certainty, all[i].certainty) << i;
    }
}

// A drill may return into its hole at rapid, but no deeper, and not before the hole exists.
TEST(RapidInMaterial, IsNoneInAHoleThatAPeckLeft) {
    verify::Setup setup = plain_setup();
    const auto found = [&](const std::string& moves) {
        return findings_of(verdict_of(kStart + moves, setup), "rapid-in-material").size();
    };
    EXPECT_EQ(found("G0 X0 Y0 Z1\nG1 Z-2\nG0 Z1\nG0 Z-2\nG1 Z-4\nG0 Z1\nG0 Z-4\nG0 Z1\n"), 0U);
    EXPECT_EQ(found("G0 X0 Y0 Z1\nG1 Z-2\nG0 Z1\nG0 Z-2.01\nG0 Z1\n"), 1U);
    EXPECT_EQ(found("G0 X0 Y0 Z1\nG1 Z-2\nG0 Z1\nX0.01\nG0 Z-2\nG0 Z1\n"), 1U);
    EXPECT_EQ(found("G0 X0 Y0 Z1\nG0 Z-2\nG1 Z-2\nG0 Z1\nG0 Z-2\nG0 Z1\n"), 1U);
    // Along a slot and back; next to the slot are walls.
    EXPECT_EQ(found("G0 X-30 Y0 Z-2\nG1 X10\nG0 X-30\nG0 X10\n"), 0U);
    EXPECT_EQ(found("G0 X-30 Y0 Z-2\nG1 X10\nG0 X-30 Y1\n"), 1U);
}

TEST(RapidInMaterial, IsFoundOnTheWayUpOutOfATunnel) {
    // Flutes of 5 mm at Z-9 leave a roof of 4 mm.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::flat_end_mill(10.0, 5.0);
    const auto verdict = verdict_of(kStart + "G0 Z-9\nG1 X0\nG0 Z5\n", setup);
    const Finding f = only(verdict, "rapid-in-material");
    EXPECT_EQ(f.place.span.line, 4U);
    EXPECT_NEAR(f.quantity->value, 4 * 3.14159 * 25, 5.0);
    // Above a plunged hole no material is left.
    const auto hole = verdict_of(kStart + "G0 X0\nG1 Z-9\nG0 Z5\n", setup);
    EXPECT_TRUE(findings_of(hole, "rapid-in-material").empty());
}

TEST(RapidInMaterial, IsNotFoundWhereTheToolOnlyTouches) {
    // Next to the block, on top of the block, and back through the slot that was cut at feed.
    const auto verdict = verdict_of(kStart +
                                    "G0 Y-20 Z-5\nG0 X30\nG0 Z0\nG0 Y0\nG0 X-30\n"
                                    "G0 Z-2\nG1 X30\nG0 X-30\nG0 Z5\n");
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    EXPECT_EQ(skipped_because(verdict, "rapid-in-material"), "");
}

TEST(RapidInMaterial, IsNotFoundWhereAConeGoesBackUp) {
    // The planes of a cone are rounded, so the end of a sweep and the beginning of the next sweep
    // differ by a negligible volume: 1e-13 mm³ here.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::v_cutter(6.35, 0.0, 90.0, 30.0);
    const auto verdict = verdict_of(
        "G20 G90 G17 T1 M6 S1000 M3 F10 G0 X0.0387 Y0.1609 Z0.5\nG1 Z-0.05\n"
        "G1 X0.0405 Y0.1562\nG0 Z0.5\n",
        setup);
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    // 0.1 µm is more than rounding.
    const auto bite = verdict_of(
        "G21 G90 G17 T1 M6 S1000 M3 F100 G0 X0 Y0 Z5\nG1 Z-1\nG1 X3\nG0 Z-1.0001\nG0 Z5\n", setup);
    EXPECT_EQ(only(bite, "rapid-in-material").place.span.line, 4U);
}

// Returns the verdict of a V-cutter that moves down, sideways, and after `before_up` back up at
// feed: 100 times, at positions where the end of a sweep and the beginning of the next sweep differ
// by rounding.
verify::Verdict of_cone_going_back_up(const std::string& before_up, bool ledger) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::v_cutter(6.0, 0.0, 30.0, 20.0);
    setup.ledger = ledger;
    setup.air_cuts = true;
    std::string program = "G21 G90 G17 T1 M6 F100 G0 X0 Y0 Z5\n";
    std::mt19937 random(5);
    const auto word = [&random](const char* letter, int from, int to) {
        const int steps = from + static_cast<int>(random() % static_cast<unsigned>(to - from));
        return letter + std::to_string(1e-4 * steps);
    };
    for (int i = 0; i < 100; ++i) {
        program += "S1000 M3 G0" + word(" X", -150000, 150000) + word(" Y", -100000, 100000) +
                   "\nG1" + word(" Z-", 1000, 20000) + "\nG91 G1" + word(" X", -10000, 10000) +
                   word(" Y", -10000, 10000) + "\nG90 " + before_up + "\nG1 Z5\n";
    }
    return verdict_of(program, setup);
}

TEST(Slivers, BetweenTheRoundedPlanesOfConesAreNoFindings) {
    for (const bool ledger : {false, true}) {
        SCOPED_TRACE(ledger);
        EXPECT_TRUE(findings_of(of_cone_going_back_up("M5", ledger), "spindle-off").empty());
        const auto reversed = of_cone_going_back_up("M4", ledger);
        EXPECT_TRUE(findings_of(reversed, "spindle-reversed").empty());
        // A few further moves repeat earlier moves.
        EXPECT_GE(std::stoi(only(reversed, "air-cut").message), 100);
        // 1 µm deeper is more than rounding, if no deeper cut came before.
        const auto deeper = of_cone_going_back_up("M5 G91\nG1 Z-0.001\nG90", ledger);
        EXPECT_EQ(findings_of(deeper, "spindle-off").size(), 99U);
    }
}

TEST(Slivers, DoNotUnsettleTheBooks) {
    const auto verdict = of_cone_going_back_up("", true);
    for (const verify::LedgerRow& row : verdict.ledger.rows)
        EXPECT_GE(row.removed_mm3, 0.0) << "line " << row.line;
    EXPECT_LT(verdict.ledger.imbalance(), 1e-12);
}

TEST(RapidInMaterial, IsFoundForTheSmallestBite) {
    // 1 µm deep over 40 mm.
    const auto verdict = verdict_of(kStart + "G0 Z-0.001\nG0 X30\n");
    expect_at(only(verdict, "rapid-in-material"), 3, 0.4);
}

TEST(RapidInMaterial, ThatOnlyTheCircumscribedToolMakesIsNotCertain) {
    // Down next to a corner of the block at a distance of 0.05 mm. The polygon has 16 sides and a
    // corner that extends 0.098 mm beyond the circle.
    verify::Setup setup = plain_setup();
    setup.accuracy.tolerance_mm = 0.2;
    const std::string down = "G21 G90 T1 M6 S1000 M3 G0 X24.19892 Y17.80563 Z5\nG0 Z-5\n";
    const Finding f = only(verdict_of(down, setup), "rapid-in-material");
    EXPECT_EQ(f.certainty, Certainty::Within);
    EXPECT_EQ(f.severity, Severity::Warning);
    setup.accuracy.tolerance_mm = 0.005;
    EXPECT_TRUE(findings_of(verdict_of(down, setup), "rapid-in-material").empty());
}

// The caller decides the contact that the accuracy of the tool leaves open.
TEST(RapidInMaterial, IsAsTheCallerDecidesAnOpenContact) {
    verify::Setup setup = plain_setup();
    setup.accuracy.tolerance_mm = 0.2;
    setup.decides_contacts = true;
    const std::string down = "G21 G90 T1 M6 S1000 M3 G0 X24.19892 Y17.80563 Z5\nG0 Z-5\n";
    std::vector<verify::OpenContact> asked;
    verify::ContactDecision decision = Certainty::Certain;
    const auto decide = [&](const verify::OpenContact& contact) {
        asked.push_back(contact);
        return decision;
    };
    const Finding f = only(verdict_of(down, setup, decide), "rapid-in-material");
    EXPECT_EQ(f.certainty, Certainty::Certain);
    EXPECT_EQ(f.severity, Severity::Error);
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked[0].rule, "rapid-in-material");
    EXPECT_EQ(asked[0].motion, f.first_motion);
    EXPECT_EQ(asked[0].tool, 1);
    EXPECT_FALSE(asked[0].piece);
    // The corner of the block, which the true circle does not reach.
    ASSERT_FALSE(asked[0].boxes.empty());
    for (const Box& box : asked[0].boxes)
        EXPECT_TRUE(box.overlaps({{19.9, 14.9, -5.1}, {20, 15, 0}}));

    decision = Certainty::Within;
    EXPECT_EQ(only(verdict_of(down, setup, decide), "rapid-in-material").certainty,
              Certainty::Within);
    decision = std::nullopt;
    EXPECT_TRUE(findings_of(verdict_of(down, setup, decide), "rapid-in-material").empty());
    // Without decisions, the contact stays open.
    EXPECT_EQ(only(verdict_of(down, setup), "rapid-in-material").certainty, Certainty::Within);
    // A contact that is certain, or none, is not open.
    asked.clear();
    (void)verdict_of(kStart + "G0 Z-1\nG0 X30\n", setup, decide);
    EXPECT_TRUE(asked.empty());
}

TEST(RapidInMaterial, OfSuccessiveMovesIsOneFinding) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X0\nX10\nX30\nG0 Z5\n");
    const Finding f = only(verdict, "rapid-in-material");
    expect_at(f, 3, 800.0);
    EXPECT_EQ(f.last.span.line, 5U);
    EXPECT_EQ(f.count, 3U);
}

TEST(RapidInMaterial, DependsOnThePathOfTheMachine) {
    // On a straight line the tool passes the corner of the block; on a dog-leg path the tool cuts
    // through the corner.
    const std::string program = "G21 G90 T1 M6 S1000 M3 G0 X-40 Y-15 Z-5\nG0 X-19 Y-36\n";
    verify::Setup setup = plain_setup();
    EXPECT_TRUE(findings_of(verdict_of(program, setup), "rapid-in-material").empty());
    const std::string unequal = "G21 G90 T1 M6 S1000 M3 G0 X-40 Y-25 Z-5\nG0 X0 Y10\n";
    EXPECT_EQ(findings_of(verdict_of(unequal, setup), "rapid-in-material").size(), 1U);
    setup.rapid.dog_leg = true;
    setup.rapid.rates = {1.0, 1000.0, 1.0};  // Y first, next to the block, then X into the block
    const Finding f = only(verdict_of(unequal, setup), "rapid-in-material");
    // A slot of 10 mm from X-20 to the axis at X0, 5 mm deep, and half a polygon of the tool.
    EXPECT_GT(f.quantity->value, 20 * 10 * 5.0);
    EXPECT_EQ(f.assumptions.back(),
              "path: each axis moves at its own rapid rate (--rapid dog-leg)");
}

TEST(RapidInMaterial, NamesWhatItRestsOnAndIsThenAWarning) {
    verify::Setup setup = plain_setup();
    setup.stock_assumption = "derived";
    const Finding f = only(verdict_of(kStart + "G0 Z-2\nG0 X30\n", setup), "rapid-in-material");
    EXPECT_EQ(f.severity, Severity::Warning);
    EXPECT_EQ(f.assumptions,
              (std::vector<std::string>{"stock: derived",
                                        "path: rapid moves are straight (--rapid linear)"}));
}

TEST(RapidInMaterial, AfterAProbeRestsOnWhereItMetSomething) {
    const Finding f =
        only(verdict_of(kStart + "G0 X0\nG38.2 Z-3 F50\nG0 X10\n"), "rapid-in-material");
    EXPECT_EQ(f.place.span.line, 4U);
    EXPECT_EQ(f.severity, Severity::Warning);
    EXPECT_EQ(f.assumptions.front().substr(0, 6), "probe:");
}

TEST(RapidInMaterial, OfATurnedToolRestsOnTheKinematics) {
    const std::string slot = "G0 Z-2\nG0 X30\n";
    const Finding turned =
        only(verdict_of(kStart + "G0 A90\n" + "G0 Y-2 Z0\nG0 X30\n"), "rapid-in-material");
    EXPECT_EQ(turned.assumptions.front(), "kinematics: A, B and C turn about the program origin");
    const Finding upright = only(verdict_of(kStart + slot), "rapid-in-material");
    EXPECT_EQ(upright.assumptions.front().substr(0, 5), "path:");
}

TEST(RapidInMaterial, IsSkippedWhereNothingIsSimulated) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X30\n", not_simulated());
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    EXPECT_EQ(skipped_because(verdict, "rapid-in-material"),
              "the program was not simulated: tool 7 is not described");
}

}  // namespace
}  // namespace ncsim::verify_test
