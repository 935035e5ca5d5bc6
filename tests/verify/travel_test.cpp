// SPDX-License-Identifier: GPL-3.0-or-later
//
// Travels, unknown starts, and messages of the interpreter. Each rule has a program that violates
// the rule at a known line by a known amount, a program that just keeps the rule, and a program for
// which the rule cannot be checked.
#include "verify/expected.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace ncsim::verify_test {
namespace {

using verify::Finding;
using verify::Severity;

TEST(OverTravel, IsFoundWithTheDistance) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[0] = {-100, 0};
    setup.machine.travel[2] = {-50, 0};
    setup.machine.work_zero = Vec3{-60, 0, -40};
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
    setup.machine.work_zero = Vec3{};
    const auto verdict = verdict_of(kStart + "G2 X20 Y0 R25\n", setup);
    expect_at(only(verdict, "over-travel"), 2, 0.5, 0.011);
}

TEST(OverTravel, OfArcsIsFoundHoweverSmall) {
    // Sampling the arcs every 0.01 mm would miss 72 of these cases.
    std::mt19937 random(7);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    for (int i = 0; i < 150; ++i) {
        const double radius = between(5.0, 200.0);
        const double beyond = between(1e-4, 8e-3);
        // start angle from the X axis of the arc over the top
        const double from = between(0.1, 1.4);
        const double to = between(0.1, 1.4);  // end angle from the X axis
        const double x = -radius * std::cos(from);
        const double y = radius * std::sin(from);
        verify::Setup setup = not_simulated();
        setup.machine.travel[1] = {-1000.0, radius - beyond};
        setup.machine.work_zero = Vec3{};
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
    setup.machine.work_zero = Vec3{0, -257.033, 0};
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
    setup.machine.work_zero = Vec3{-60, 0, -40};
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
              "no travels are specified (machine.toml, [travel])");
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

}  // namespace
}  // namespace ncsim::verify_test
