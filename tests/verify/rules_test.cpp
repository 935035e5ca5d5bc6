// SPDX-License-Identifier: GPL-3.0-or-later
//
// For every rule: a program that breaks it at a known line by a known amount, one that only just
// keeps it, and one where it cannot be asked.
#include "verify/verified.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace ncsim::verify_test {
namespace {

using verify::Certainty;
using verify::Finding;
using verify::Severity;

// Line 1; the slots that follow begin at line 2.
const std::string kStart = "G21 G90 G17 T1 M6 S1000 M3 F500 G0 X-30 Y0 Z5\n";

Finding only(const verify::Verdict& verdict, const std::string& rule) {
    const auto found = findings_of(verdict, rule);
    EXPECT_EQ(found.size(), 1U) << rule;
    return found.empty() ? Finding{} : found.front();
}

void expect_at(const Finding& f, std::uint32_t line, double value, double tolerance = 1e-9) {
    EXPECT_EQ(f.place.span.line, line) << f.message;
    ASSERT_TRUE(f.quantity.has_value()) << f.message;
    EXPECT_NEAR(f.quantity->value, value, tolerance) << f.message;
}

verify::Setup not_simulated() {
    verify::Setup setup = plain_setup();
    setup.not_simulated = "tool 7 is not described";
    return setup;
}

// --- Rapid moves -------------------------------------------------------------------------------

TEST(RapidInMaterial, IsFoundAtItsLineWithTheVolumeItTakes) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X30\nG0 Z5\n");
    const Finding f = only(verdict, "rapid-in-material");
    expect_at(f, 3, 800.0);  // 10 x 2 over 40 mm
    EXPECT_EQ(f.severity, Severity::Error);
    EXPECT_EQ(f.certainty, Certainty::Certain);
    EXPECT_EQ(f.tool, 1);
    EXPECT_EQ(f.box, (cda::Box{{-20, -5, -2}, {20, 5, 0}}));
}

TEST(RapidInMaterial, IsFoundOnTheWayUpOutOfATunnel) {
    // Flutes of 5 mm at Z-9 leave a roof of 4 mm.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::flat_end_mill(10.0, 5.0);
    const auto verdict = verdict_of(kStart + "G0 Z-9\nG1 X0\nG0 Z5\n", setup);
    const Finding f = only(verdict, "rapid-in-material");
    EXPECT_EQ(f.place.span.line, 4U);
    EXPECT_NEAR(f.quantity->value, 4 * 3.14159 * 25, 5.0);
    // Of a hole nothing is left above it.
    const auto hole = verdict_of(kStart + "G0 X0\nG1 Z-9\nG0 Z5\n", setup);
    EXPECT_TRUE(findings_of(hole, "rapid-in-material").empty());
}

TEST(RapidInMaterial, IsNotFoundWhereTheToolOnlyTouches) {
    // Beside the block, on top of it, and back through the slot that was cut at feed.
    const auto verdict = verdict_of(kStart +
                                    "G0 Y-20 Z-5\nG0 X30\nG0 Z0\nG0 Y0\nG0 X-30\n"
                                    "G0 Z-2\nG1 X30\nG0 X-30\nG0 Z5\n");
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    EXPECT_EQ(skipped_because(verdict, "rapid-in-material"), "");
}

TEST(RapidInMaterial, IsNotFoundWhereAConeGoesBackUp) {
    // The planes of a cone are rounded, so the end of one sweep and the beginning of the next
    // differ by less than anything: 1e-13 mm3 here.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::v_cutter(6.35, 0.0, 90.0, 30.0);
    const auto verdict = verdict_of(
        "G20 G90 G17 T1 M6 S1000 M3 F10 G0 X0.0387 Y0.1609 Z0.5\nG1 Z-0.05\n"
        "G1 X0.0405 Y0.1562\nG0 Z0.5\n",
        setup);
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    // A tenth of a micrometre is more than rounding.
    const auto bite = verdict_of(
        "G21 G90 G17 T1 M6 S1000 M3 F100 G0 X0 Y0 Z5\nG1 Z-1\nG1 X3\nG0 Z-1.0001\nG0 Z5\n", setup);
    EXPECT_EQ(only(bite, "rapid-in-material").place.span.line, 4U);
}

// A V-cutter goes down, sideways, and after `before_up` back up at feed: 100 times, at places where
// the end of one sweep and the beginning of the next differ by rounding.
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
        // And a few that go where others were.
        EXPECT_GE(std::stoi(only(reversed, "air-cut").message), 100);
        // A micrometre deeper is more than rounding, where no deeper cut was.
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
    // A micrometre deep over 40 mm.
    const auto verdict = verdict_of(kStart + "G0 Z-0.001\nG0 X30\n");
    expect_at(only(verdict, "rapid-in-material"), 3, 0.4);
}

TEST(RapidInMaterial, ThatOnlyTheCircumscribedToolMakesIsNotCertain) {
    // Down beside a corner of the block, 0.05 mm away from it, where the polygon of 16 sides has a
    // corner that reaches 0.098 mm beyond the circle.
    verify::Setup setup = plain_setup();
    setup.accuracy.tolerance_mm = 0.2;
    const std::string down = "G21 G90 T1 M6 S1000 M3 G0 X24.19892 Y17.80563 Z5\nG0 Z-5\n";
    const Finding f = only(verdict_of(down, setup), "rapid-in-material");
    EXPECT_EQ(f.certainty, Certainty::Within);
    EXPECT_EQ(f.severity, Severity::Warning);
    setup.accuracy.tolerance_mm = 0.005;
    EXPECT_TRUE(findings_of(verdict_of(down, setup), "rapid-in-material").empty());
}

TEST(RapidInMaterial, OfSuccessiveMovesIsOneFinding) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X0\nX10\nX30\nG0 Z5\n");
    const Finding f = only(verdict, "rapid-in-material");
    expect_at(f, 3, 800.0);
    EXPECT_EQ(f.last.span.line, 5U);
    EXPECT_EQ(f.count, 3U);
}

TEST(RapidInMaterial, DependsOnThePathOfTheMachine) {
    // Straight, the tool passes the corner of the block; as a dog-leg it goes through it.
    const std::string program = "G21 G90 T1 M6 S1000 M3 G0 X-40 Y-15 Z-5\nG0 X-19 Y-36\n";
    verify::Setup setup = plain_setup();
    EXPECT_TRUE(findings_of(verdict_of(program, setup), "rapid-in-material").empty());
    const std::string unequal = "G21 G90 T1 M6 S1000 M3 G0 X-40 Y-25 Z-5\nG0 X0 Y10\n";
    EXPECT_EQ(findings_of(verdict_of(unequal, setup), "rapid-in-material").size(), 1U);
    setup.rapid.dog_leg = true;
    setup.rapid.rates = {1.0, 1000.0, 1.0};  // Y first, beside the block, then X into it
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

// --- Spindle and feed --------------------------------------------------------------------------

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
    // 60 mm in a tenth of a minute; 1.5 mm in each of 1000 turns a minute.
    const auto verdict =
        verdict_of(kStart + "G93 G1 X30 F10\nG1 X-30 F20\nG95 G1 X30 F1.5\n", setup);
    const auto found = findings_of(verdict, "feed-limit");
    ASSERT_EQ(found.size(), 1U);
    expect_at(found[0], 3, 1500.0);
    EXPECT_EQ(found[0].count, 2U);
}

// --- What does not cut -------------------------------------------------------------------------

TEST(NonCuttingContact, IsFoundWithTheStickOutThatIsMissing) {
    // The shank begins 5 mm above the tip: at 8 mm deep it stands 3 mm in the material.
    const auto verdict = verdict_of(kStart + "G0 Z-8\nG1 X30\n", setup_with_holder());
    const Finding f = only(verdict, "non-cutting-contact");
    expect_at(f, 3, 3.0, 1e-9);
    EXPECT_EQ(f.certainty, Certainty::Certain);
    EXPECT_EQ(f.quantity->name, "stick-out missing");
}

TEST(NonCuttingContact, IsNotFoundWhereTheShankOnlyTouches) {
    const auto verdict =
        verdict_of(kStart + "G0 Z-5\nG1 X30\nG0 Z5\nG0 X-30\nZ-10\nG1 X30\n", setup_with_holder());
    EXPECT_TRUE(findings_of(verdict, "non-cutting-contact").empty());
}

TEST(NonCuttingContact, FindsAHolderThatFollowsTheCutterDown) {
    // The shank goes where the cutter was; the holder, 30 mm up, comes down to the block.
    verify::Setup setup = setup_with_holder();
    setup.tools.at(1).tool = toolpath::flat_end_mill(10.0, 5.0);
    toolpath::add_holder_segment(setup.tools.at(1).tool, 10.0, 10.0, 3.0);
    toolpath::add_holder_segment(setup.tools.at(1).tool, 40.0, 40.0, 30.0);
    const auto clear = verdict_of(kStart + "G0 X0\nG1 Z-8\nG1 Z5\n", setup);
    EXPECT_TRUE(findings_of(clear, "non-cutting-contact").empty());
    const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-9.5\nG1 Z5\n", setup);
    const auto found = findings_of(verdict, "non-cutting-contact");
    ASSERT_EQ(found.size(), 1U);
    expect_at(found[0], 3, 1.5);
    EXPECT_EQ(found[0].message,
              "the D40 segment of T1 from 8 to 38 mm above its tip, which does not cut, meets "
              "material");
}

TEST(NonCuttingContact, IsNotFoundWhereAShankAsThickAsARoundToolFollowsIt) {
    // A ball is another polygon than a cylinder of its diameter; corners stood out of it by less
    // than the tolerance, however fine that was.
    for (toolpath::Tool tool :
         {toolpath::ball_end_mill(5.188, 3.0), toolpath::bull_nose_end_mill(5.188, 1.297, 3.0),
          toolpath::bull_nose_end_mill(9.2456, 1.53924, 4.3434)}) {
        toolpath::add_holder_segment(tool, 2 * tool.pieces[0].profile.back().radius,
                                     2 * tool.pieces[0].profile.back().radius, 20.0);
        verify::Setup setup = plain_setup();
        setup.tools.at(1).tool = tool;
        const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-9\nG1 Z5\n", setup);
        EXPECT_TRUE(findings_of(verdict, "non-cutting-contact").empty());
        // It still does not cut: across, it has to stand above the rest of the block.
        const auto across = verdict_of(kStart + "G0 X0\nG1 Z-9\nG1 X5\n", setup);
        const Finding f = only(across, "non-cutting-contact");
        EXPECT_EQ(f.place.span.line, 4U);
        EXPECT_EQ(f.certainty, Certainty::Certain);
    }
}

TEST(NonCuttingContact, IsNotFoundInTheTurnsOfAHelixThatTheCutterMadeBefore) {
    verify::Setup setup = plain_setup();
    toolpath::Tool tool = toolpath::flat_end_mill(7.43, 3.0);
    toolpath::add_holder_segment(tool, 7.43, 7.43, 20.0);
    setup.tools.at(1).tool = tool;
    const auto verdict = verdict_of(
        kStart + "G0 X3.577\nG0 Z0\nG3 X3.577 Y0 Z-8.5 I-3.577 J0 P3\nG3 I-3.577 J0\nG0 Z5\n",
        setup);
    EXPECT_TRUE(findings_of(verdict, "non-cutting-contact").empty());
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
}

TEST(NonCuttingContact, SeesTheShankOfAToolThatRisesBeforeItsCutter) {
    // Upwards and sideways out of a hole: the shank meets the wall before the cutter does.
    const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-8\nG1 X5 Z-7\n", setup_with_holder());
    EXPECT_EQ(only(verdict, "non-cutting-contact").place.span.line, 4U);
}

TEST(NonCuttingContact, IsSkippedWhereNobodyTellsAShank) {
    EXPECT_EQ(skipped_because(verdict_of(kStart), "non-cutting-contact"),
              "neither flute length, shank nor holder is told of T1");
}

TEST(Plunge, IsFoundForToolsThatDoNotCutAtTheirCentre) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 4.0;
    const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-2\n", setup);
    const Finding f = only(verdict, "plunge");
    expect_at(f, 3, 2.0, 0.0101);
}

TEST(Plunge, IsFoundHoweverLittleItGoesAside) {
    // A micrometre; a helix of 1 mm; a ramp of 30 degrees; to and fro by less than the core.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 6.0;
    for (const char* program :
         {"G0 X0 Z1\nG1 X0.001 Z-2\n", "G0 X0 Z0\nG3 X0 Y0 Z-2 I0.5 J0 P10\n",
          "G0 X0 Z1\nG1 X7 Z-3\n",
          "G0 X0 Z0\nG1 X2 Z-0.1\nX0 Z-0.2\nX2 Z-0.3\nX0 Z-0.4\nX2 Z-0.5\nX0 Z-0.6\n"
          "X2 Z-0.7\nX0 Z-0.8\nX2 Z-0.9\nX0 Z-1\nX2 Z-1.1\nX0 Z-1.2\n"}) {
        SCOPED_TRACE(program);
        EXPECT_FALSE(findings_of(verdict_of(kStart + program, setup), "plunge").empty());
    }
    // A helix that is wide enough, and a ramp that turns back.
    for (const char* program :
         {"G0 X0 Z0\nG3 X0 Y0 Z-2 I4 J0 P2\n", "G0 X-8 Z0\nG1 X8 Z-1\nX-8 Z-2\nX8 Z-3\n"}) {
        SCOPED_TRACE(program);
        EXPECT_TRUE(findings_of(verdict_of(kStart + program, setup), "plunge").empty());
    }
}

TEST(Plunge, IsNotFoundOnARampBesideTheBlockOrForOtherTools) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 4.0;
    // With its rim over the edge of the block only; then on a ramp.
    const std::string program = "G0 X-22\nG1 Z-2\nG1 X10 Z-4\nG0 Z5\n";
    EXPECT_TRUE(findings_of(verdict_of(kStart + program, setup), "plunge").empty());
    EXPECT_TRUE(findings_of(verdict_of(kStart + "G0 X0\nG1 Z-2\n"), "plunge").empty());
}

// --- Limits of removal -------------------------------------------------------------------------

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
    // The cylinder above the limit was taken away with the ball, with 680.9 mm3 instead of 449.6.
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
    // 800 mm3 on 60 mm at 500 mm/min.
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

// --- Travel and set-up -------------------------------------------------------------------------

TEST(OverTravel, IsFoundWithTheDistance) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[0] = {-100, 0};
    setup.machine.travel[2] = {-50, 0};
    setup.machine.work_zero = cda::Vec3{-60, 0, -40};
    const auto verdict = verdict_of(kStart + "G0 X60\nG0 X-40\nG0 X-40.25\nG0 Z40.5\n", setup);
    const auto found = findings_of(verdict, "over-travel");
    ASSERT_EQ(found.size(), 2U);
    expect_at(found[0], 4, 0.25);
    EXPECT_EQ(found[0].message, "X runs beyond its lower end at -100");
    expect_at(found[1], 5, 0.5);
    EXPECT_EQ(found[1].assumptions,
              std::vector<std::string>{"tool length: 0, no offset is active (G43)"});
}

TEST(OverTravel, IsFoundOnTheBulgeOfAnArc) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[1] = {-10, 24.5};
    setup.machine.work_zero = cda::Vec3{};
    const auto verdict = verdict_of(kStart + "G2 X20 Y0 R25\n", setup);
    expect_at(only(verdict, "over-travel"), 2, 0.5, 0.011);
}

TEST(OverTravel, OfArcsIsFoundHoweverSmall) {
    // 72 of these were missed where arcs were looked at every 0.01 mm.
    std::mt19937 random(7);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    for (int i = 0; i < 150; ++i) {
        const double radius = between(5.0, 200.0);
        const double beyond = between(1e-4, 8e-3);
        const double from = between(0.1, 1.4);  // the turn over the top begins at
        const double to = between(0.1, 1.4);    // and ends at, from the X axis
        const double x = -radius * std::cos(from);
        const double y = radius * std::sin(from);
        verify::Setup setup = not_simulated();
        setup.machine.travel[1] = {-1000.0, radius - beyond};
        setup.machine.work_zero = cda::Vec3{};
        const std::string program = fmt::format(
            "G21 G90 S1 M3 F1\nG0 X{:.9f} Y{:.9f} Z0\nG2 X{:.9f} Y{:.9f} I{:.9f} "
            "J{:.9f}\nM2\n",
            x, y, radius * std::cos(to), radius * std::sin(to), -x, -y);
        SCOPED_TRACE(program);
        expect_at(only(verdict_of(program, setup), "over-travel"), 3, beyond, 2e-6);
        setup.machine.travel[1]->max = radius + 2e-6;
        EXPECT_TRUE(findings_of(verdict_of(program, setup), "over-travel").empty());
    }
}

TEST(OverTravel, IsNotWhatASumOfDecimalFractionsLeaves) {
    verify::Setup setup = not_simulated();
    setup.machine.work_zero = cda::Vec3{0, -257.033, 0};
    setup.machine.travel[1] = {-287.686, 0};
    const std::string program = "G21 G90 S1 M3 F1\nG0 X0 Y0 Z0\nG0 Y-30.653\nM2\n";
    ASSERT_LT(-257.033 + -30.653, -287.686);
    EXPECT_TRUE(findings_of(verdict_of(program, setup), "over-travel").empty());
    setup.machine.travel[1]->min = -287.685999;
    expect_at(only(verdict_of(program, setup), "over-travel"), 3, 1e-6, 1e-9);
}

TEST(OverTravel, IsNotCertainInASystemThatNobodyPlaced) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[0] = {-100, 0};
    setup.machine.work_zero = cda::Vec3{-60, 0, -40};
    const auto verdict = verdict_of(kStart + "G1 X1\nG55\nG0 X60.5\n", setup);
    EXPECT_EQ(only(verdict, "over-travel").severity, Severity::Warning);
    EXPECT_EQ(verdict.outcome(), verify::Outcome::NotProven);
}

TEST(OverTravel, ComparesTheWayWhereTheZeroIsUnknown) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[0] = {-100, 0};
    const auto fits = verdict_of(kStart + "G0 X70\n", setup);
    EXPECT_TRUE(findings_of(fits, "over-travel").empty());
    EXPECT_NE(skipped_because(fits, "over-travel"), "");
    const auto verdict = verdict_of(kStart + "G0 X70\nG0 X71.5\nG0 X0\n", setup);
    expect_at(only(verdict, "over-travel"), 3, 1.5);
    EXPECT_EQ(skipped_because(verdict_of(kStart), "over-travel"),
              "no travels are told (machine.toml, [travel])");
}

TEST(StartUnknown, IsFoundForFeedMovesAndNotedForTheFirstRapid) {
    const auto verdict = verdict_of("G21 G90 T1 M6 S1000 M3 F500\nG1 X0 Y0 Z-5\nG1 X10\n");
    const Finding f = only(verdict, "start-unknown");
    EXPECT_EQ(f.place.span.line, 2U);
    EXPECT_EQ(f.severity, Severity::Warning);
    EXPECT_TRUE(findings_of(verdict, "air-cut").empty()) << "no phantom path from 0, 0, 0";
    EXPECT_EQ(only(verdict_of(kStart), "start-unknown").severity, Severity::Note);
}

TEST(Diagnostics, BecomeFindingsOfTheirRule) {
    const auto verdict = verdict_of(kStart + "G1 X (\nM777\nM777\n");
    EXPECT_EQ(findings_of(verdict, "program-fault").front().place.span.line, 2U);
    const Finding word = only(verdict, "unsupported-word");
    EXPECT_EQ(word.place.span.line, 3U);
    EXPECT_EQ(word.code, "unknown-m");
    EXPECT_EQ(word.count, 2U);
}

// --- Fixtures ----------------------------------------------------------------------------------

verify::Setup with_jaw(double clearance) {
    verify::Setup setup = setup_with_holder();
    verify::Fixture jaw;
    jaw.name = "jaw";
    jaw.box = {{-30, 15, -20}, {30, 25, 5}};
    jaw.clearance_mm = clearance;
    setup.machine.fixtures.push_back(jaw);
    return setup;
}

TEST(FixtureContact, IsFoundForTheCutter) {
    const auto verdict = verdict_of(kStart + "G0 Y9.9 Z-2\nG1 X30\nG1 Y10.1\n", with_jaw(0));
    const auto found = findings_of(verdict, "fixture-contact");
    ASSERT_EQ(found.size(), 2U) << "the cutter, and the shank above it";
    EXPECT_EQ(found[0].place.span.line, 4U);
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    EXPECT_EQ(found[0].message, "the cutter of T1 meets the fixture 'jaw'");
}

TEST(FixtureContact, IsNotFoundWhereTheToolOnlyTouches) {
    const auto verdict = verdict_of(kStart + "G0 Y10 Z-2\nG1 X30\n", with_jaw(0));
    EXPECT_TRUE(findings_of(verdict, "fixture-contact").empty());
    EXPECT_NE(skipped_because(verdict_of(kStart), "fixture-contact"), "");
}

TEST(FixtureContact, IsFoundForTheHolder) {
    // The holder begins 30 mm above the tip and reaches 20 mm sideways; the jaw stands at Z5.
    const auto clear = verdict_of(kStart + "G0 Y0 Z-25\n", with_jaw(0));
    EXPECT_TRUE(findings_of(clear, "fixture-contact").empty());
    const auto verdict = verdict_of(kStart + "G0 Y0 Z-25.1\n", with_jaw(0));
    const auto found = findings_of(verdict, "fixture-contact");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "shank or holder of T1 meets the fixture 'jaw'");
}

TEST(FixtureClearance, IsAWarningOfItsOwn) {
    const auto verdict = verdict_of(kStart + "G0 Y9 Z-2\nG1 X30\nG0 Y8\n", with_jaw(1.5));
    const auto found = findings_of(verdict, "fixture-clearance");
    ASSERT_EQ(found.size(), 2U) << "the cutter, and the shank above it";
    const Finding& f = found.front();
    EXPECT_EQ(f.place.span.line, 2U);
    EXPECT_EQ(f.severity, Severity::Warning);
    EXPECT_TRUE(findings_of(verdict, "fixture-contact").empty());
    const auto far = verdict_of(kStart + "G0 Y8.5 Z-2\nG1 X30\n", with_jaw(1.5));
    EXPECT_TRUE(findings_of(far, "fixture-clearance").empty());
}

TEST(FixtureContact, IsNotFoundWhereAConeOnlyTouches) {
    // Its planes are rounded outwards, by less than the fixture would notice.
    verify::Setup setup = plain_setup();
    setup.tools.at(1).tool = toolpath::v_cutter(6.0, 0.0, 60.0, 30.0);
    verify::Fixture table;
    table.name = "table";
    table.box = {{-50, -50, -60}, {50, 50, -40}};
    setup.machine.fixtures.push_back(table);
    const std::string program = "G21 G90 T1 M6 S1000 M3 G0 X37.123 Y31.37 Z5\nG0 Z-40\n";
    EXPECT_TRUE(findings_of(verdict_of(program, setup), "fixture-contact").empty());
    const auto lower = verdict_of(program + "G0 Z-40.001\n", setup);
    EXPECT_EQ(only(lower, "fixture-contact").place.span.line, 3U);
}

TEST(FixtureContact, IsFoundForAMesh) {
    // The same jaw as a closed surface of triangles.
    verify::Setup setup = with_jaw(0);
    cda::TriangleMesh& mesh = setup.machine.fixtures[0].mesh;
    const cda::Box b = setup.machine.fixtures[0].box;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                                 (i & 4) != 0 ? b.max.z : b.min.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const auto verdict = verdict_of(kStart + "G0 Y9.9 Z-2\nG1 X30\nG1 Y10.1\n", setup);
    const auto found = findings_of(verdict, "fixture-contact");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].place.span.line, 4U);
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    const auto clear = verdict_of(kStart + "G0 Y10 Z-2\nG1 X30\n", setup);
    EXPECT_TRUE(findings_of(clear, "fixture-contact").empty());
}

// --- Selection and suppression -----------------------------------------------------------------

TEST(Selection, LeavesRulesOutAndChangesTheirWeight) {
    verify::Setup setup = plain_setup();
    setup.selection.ignored = {"rapid-in-material"};
    setup.selection.severities["no-feed"] = Severity::Note;
    const auto verdict =
        verdict_of("G21 G90 T1 M6 S1000 M3 G0 X-30 Y0 Z-2\nG0 X30\nG1 X0\n", setup);
    EXPECT_TRUE(findings_of(verdict, "rapid-in-material").empty());
    EXPECT_EQ(only(verdict, "no-feed").severity, Severity::Note);
}

TEST(Suppression, IsForTheNextBlockOnly) {
    const auto verdict = verdict_of(kStart +
                                    "G0 Z-2\n(ncsim: ignore rapid-in-material)\n\nG0 X0\n"
                                    "G0 X30\n");
    const auto found = findings_of(verdict, "rapid-in-material");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[0].suppressed);
    EXPECT_EQ(found[0].place.span.line, 5U);
    EXPECT_FALSE(found[1].suppressed);
    EXPECT_EQ(verdict.count(Severity::Error), 1U);
    EXPECT_EQ(verdict.suppressed(), 1U);
}

TEST(Suppression, MayStandInTheBlockAndNameACategory) {
    const auto verdict = verdict_of(kStart + "G0 Z-2\nG0 X30 (ncsim: ignore collision, travel)\n");
    EXPECT_TRUE(only(verdict, "rapid-in-material").suppressed);
}

TEST(Suppression, IsReadWithAnyBlanksAndCase) {
    for (const char* comment :
         {"(ncsim:ignore rapid-in-material)", "(NCSIM :  IGNORE rapid-in-material)",
          "( ncsim: ignore,rapid-in-material)", "; ncsim\t:ignore\trapid-in-material"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_TRUE(findings_of(verdict, "suppression").empty());
        const verify::Suppressions read({"", std::string("G1 X1 ") + comment + "\n"});
        EXPECT_TRUE(read.covers(1, "rapid-in-material"));
    }
}

TEST(Suppression, ThatCannotBeUnderstoodIsTold) {
    for (const char* comment :
         {"(ncsim: ignores rapid-in-material)", "(ncsim ignore rapid-in-material)",
          "(ncsim: ignore)", "(ncsim:)", "(ncsim-ignore: rapid-in-material)", "(NCSIM, ignoring x)",
          "(ncsim: ingore rapid-in-material)", "(ncsim: ignore: rapid-in-material)"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_EQ(only(verdict, "suppression").place.span.line, 2U);
        EXPECT_EQ(only(verdict, "suppression").message,
                  "this comment suppresses nothing: it has to read (ncsim: ignore RULE)");
        EXPECT_FALSE(only(verdict, "rapid-in-material").suppressed);
    }
}

TEST(Suppression, IsNotLookedForInWhatPeopleSayOfUs) {
    for (const char* comment : {"(ncsim found this)", "(ncsimulator: ignore all)", "(see ncsim: x)",
                                "(NCSIM 0.1)", "(ncsim)"}) {
        SCOPED_TRACE(comment);
        const auto verdict = verdict_of(kStart + comment + "\nG0 Z-2\nG0 X30\n");
        EXPECT_TRUE(findings_of(verdict, "suppression").empty());
    }
}

TEST(Suppression, OfAnUnknownRuleIsTold) {
    const auto verdict = verdict_of(kStart + "(ncsim: ignore rapids)\nG0 Z-2\nG0 X30\n");
    EXPECT_EQ(only(verdict, "suppression").place.span.line, 2U);
    EXPECT_FALSE(only(verdict, "rapid-in-material").suppressed);
}

TEST(Rules, HaveStableNamesAReasonAndARemedy) {
    for (const verify::RuleInfo& rule : verify::rules()) {
        EXPECT_EQ(verify::find_rule(rule.id), verify::find_rule(std::string(rule.id)));
        EXPECT_FALSE(rule.why.empty());
        EXPECT_FALSE(rule.fix.empty());
        for (const char c : rule.id)
            EXPECT_TRUE((c >= 'a' && c <= 'z') || c == '-') << rule.id;
    }
    EXPECT_EQ(verify::rules_named("travel").size(), 2U);
    EXPECT_TRUE(verify::rules_named("no-such-rule").empty());
}

}  // namespace
}  // namespace ncsim::verify_test
