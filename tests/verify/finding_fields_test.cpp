// SPDX-License-Identifier: GPL-3.0-or-later
//
// All fields of findings: places, boxes, points, sums, hashes of rows. The boxes follow from the
// block, 40 x 30 x 10 mm below Z0, and from paths of T1, 10 mm in diameter.
#include "verify/expected.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::verify_test {
namespace {

using verify::Finding;

/// Lattices round outwards; polygons around round tools are larger by their accuracy.
void expect_box(const Box& box, const Box& expected, double near = 1e-4) {
    ASSERT_FALSE(box.is_empty());
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], expected.min[axis], near) << "XYZ"[axis];
        EXPECT_NEAR(box.max[axis], expected.max[axis], near) << "XYZ"[axis];
    }
}

void expect_lines(const Finding& f, std::uint32_t first, std::uint32_t last, std::uint64_t count) {
    EXPECT_EQ(f.place.span.line, first);
    EXPECT_EQ(f.last.span.line, last);
    EXPECT_EQ(f.count, count);
    EXPECT_EQ(f.last_motion - f.first_motion + 1, count);
    EXPECT_EQ(f.tool, 1);
    EXPECT_EQ(f.row == 0, count == 1) << "hash of a row";
}

verify::Setup with_travel(std::optional<Vec3> zero) {
    verify::Setup setup = plain_setup();
    setup.machine.travel[0] = {-40, 40};
    setup.machine.work_zero = zero;
    return setup;
}

TEST(FindingFields, OfAPlunge) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 6.0;
    const Finding f = only(verdict_of(kStart + "G0 X5 Y3\nG1 Z-3\nG1 X9\n", setup), "plunge");
    expect_lines(f, 3, 3, 1);
    expect_at(f, 3, 3.0);
    expect_box(f.box, {{2, 0, -3}, {8, 6, 0}}, 0.05);
}

TEST(FindingFields, OfARapidMoveInMaterial) {
    const Finding f = only(verdict_of(kStart + "G0 Z-2\nG0 X30\nG0 Z5\n"), "rapid-in-material");
    expect_lines(f, 3, 3, 1);
    expect_at(f, 3, 800.0, 1e-6);
    EXPECT_EQ(f.quantity->name, "removed");
    expect_box(f.box, {{-20, -5, -2}, {20, 5, 0}});
    ASSERT_TRUE(f.point);
    EXPECT_NEAR(f.point->x, -20.0, 1e-4);
    EXPECT_LE(std::abs(f.point->y), 5.0);
    EXPECT_EQ(f.assumptions,
              std::vector<std::string>{"path: rapid moves are straight (--rapid linear)"});
}

TEST(FindingFields, OfASpindleThatStands) {
    const Finding f = only(verdict_of(kStart + "M5\nG0 Z-2\nG1 X0\nG1 X30\n"), "spindle-off");
    expect_lines(f, 4, 5, 2);
    expect_at(f, 4, 800.0, 1e-6);
    EXPECT_EQ(f.quantity->name, "removed");  // both moves were measured
    expect_box(f.box, {{-20, -5, -2}, {20, 5, 0}});
    EXPECT_TRUE(f.point);
}

TEST(FindingFields, OfAShank) {
    // The shank begins 5 mm above the tip.
    const Finding f = only(verdict_of(kStart + "G0 Z-8\nG1 X0\nG1 X30\n", setup_with_holder()),
                           "non-cutting-contact");
    expect_lines(f, 3, 4, 2);
    expect_at(f, 3, 3.0);
    expect_box(f.box, {{-20, -5, -3}, {20, 5, 0}});
    ASSERT_TRUE(f.point);
    EXPECT_NEAR(f.point->x, -20.0, 1e-4);
    EXPECT_GE(f.point->z, -3.0);
}

TEST(FindingFields, OfPathsBeyondATravel) {
    const Finding zero =
        only(verdict_of(kStart + "G1 X50 Y3 Z6\nG1 X-45\n", with_travel(Vec3{})), "over-travel");
    expect_lines(zero, 2, 3, 2);
    expect_at(zero, 2, 10.0);
    expect_box(zero.box, {{-45, 0, 5}, {50, 3, 6}});
    const Finding length = only(
        verdict_of(kStart + "G1 X60 Y3 Z6\nG1 X-45\n", with_travel(std::nullopt)), "over-travel");
    expect_lines(length, 2, 3, 2);
    expect_at(length, 2, 25.0);
    expect_box(length.box, {{-45, 0, 5}, {60, 3, 6}});
    EXPECT_EQ(length.message, "the way in X is longer than the travel of 80 mm");
}

TEST(FindingFields, RoundingIsNotBeyondATravel) {
    const auto count = [](double zero) {
        const std::string program = kStart + "G1 X40\n";
        return findings_of(verdict_of(program, with_travel(Vec3{zero, 0, 0})), "over-travel")
            .size();
    };
    EXPECT_EQ(count(0.0), 0U);
    EXPECT_EQ(count(5e-10), 0U);
    EXPECT_EQ(count(5e-9), 1U);
    EXPECT_EQ(count(-1.0), 0U);
}

TEST(FindingFields, AnyChangeInARowChangesItsHash) {
    verify::Setup setup = plain_setup();
    setup.machine.max_feed = 400;
    setup.machine.travel[0] = {-40, 40};
    setup.machine.work_zero = Vec3{};
    const auto row = [&](const std::string& rule, const std::string& blocks) {
        return only(verdict_of(kStart + blocks, setup), rule).row;
    };
    // The largest feed is the same in all; the second is not.
    const std::uint64_t feed = row("feed-limit", "G1 X0 F900\nX30 F500\n");
    EXPECT_EQ(feed, row("feed-limit", "G1 X0 F900\nX30 F500\n"));
    EXPECT_NE(feed, row("feed-limit", "G1 X0 F900\nX30 F501\n"));
    const std::uint64_t way = row("over-travel", "G1 X45\nX44\n");
    EXPECT_NE(way, row("over-travel", "G1 X45\nX44 Y1\n"));
    EXPECT_NE(way, row("over-travel", "G1 X45\nX43\n"));
}

TEST(FindingFields, AirCutsInManyPlaces) {
    // Nine times: down next to the block, through the block, and back. The first way down is line
    // 2; the way back and the next way down are one place, and the last way back is alone.
    verify::Setup setup = plain_setup();
    setup.air_cuts = true;
    std::string program = kStart;
    for (int i = 1; i <= 9; ++i)
        program += "G1 Z-0." + std::to_string(i) + "\nG1 X30\nG1 X-30\n";
    const Finding f = only(verdict_of(program, setup), "air-cut");
    EXPECT_EQ(f.message,
              "18 of 27 feed moves remove nothing, at lines 2, 4-5, 7-8, 10-11, 13-14, 16-17, "
              "19-20, 22-23 and 2 more places");
    EXPECT_EQ(f.count, 18U);
    EXPECT_EQ(f.last.span.line, 28U);
    expect_box(f.box, {{-30, 0, -0.9}, {30, 0, 5}});
}

verify::Setup with_jaws() {
    verify::Setup setup = plain_setup();
    verify::Fixture jaw;
    jaw.name = "back";
    jaw.box = {{-30, 15, -20}, {30, 25, 5}};
    setup.machine.fixtures.push_back(jaw);
    jaw.name = "stop";
    jaw.box = {{40, -25, -20}, {50, 25, 5}};
    setup.machine.fixtures.push_back(jaw);
    return setup;
}

TEST(FindingFields, AMoveThatMeetsTwoFixtures) {
    const auto found = findings_of(verdict_of(kStart + "G0 Y5 Z3\nG1 Y10.5\nG1 X36\n", with_jaws()),
                                   "fixture-contact");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].message, "the cutter of T1 meets the fixture 'back'");
    expect_lines(found[0], 3, 4, 2);
    expect_box(found[0].box, {{-30, 15, 3}, {30, 15.5, 5}}, 0.05);
    EXPECT_EQ(found[1].message, "the cutter of T1 meets the fixture 'stop'");
    expect_lines(found[1], 4, 4, 1);
    expect_box(found[1].box, {{40, 5.5, 3}, {41, 15.5, 5}}, 0.05);
}

TEST(FindingFields, ACertainContactWithinAMoveIsCertain) {
    // An arc that enters the gap of a mesh first and is deeper later: radius 205, 0.5 mm high.
    verify::Setup setup = plain_setup();
    verify::Fixture jaw;
    jaw.name = "back";
    jaw.box = {{-30, 15, -20}, {30, 25, 5}};
    jaw.deflection_mm = 0.2;
    setup.machine.fixtures.push_back(jaw);
    const auto certainty = [&](const std::string& block) {
        const auto verdict = verdict_of(kStart + "G0 Y9.9 Z3\n" + block + "\n", setup);
        const auto found = findings_of(verdict, "fixture-contact");
        return found.empty() ? std::nullopt : std::optional(found.back().certainty);
    };
    EXPECT_EQ(certainty("G1 X0"), verify::Certainty::Within);
    EXPECT_EQ(certainty("G2 X0 Y10.5 R200"), verify::Certainty::Certain);
}

TEST(FindingFields, ASpindleNoseNextToTheBlockMeetsNothing) {
    // The length of T1 is not specified: at the nose, 5 mm above the block, it may be 80 mm long.
    verify::Setup setup = plain_setup();
    setup.machine.work_zero = Vec3{0, 0, -100};
    setup.uses_length_offsets = true;
    setup.stock = kBlock;
    const auto meets = [&](const std::string& place) {
        const auto verdict =
            verdict_of("G21 G90 T1 M6 G43 H1 S1000 M3 G0 " + place + " Z90\nG53 G0 Z-95\n", setup);
        return std::ranges::any_of(verdict.doubts, [](const verify::Doubt& doubt) {
            return doubt.message.find("it meets the stock in machine coordinates") !=
                   std::string::npos;
        });
    };
    EXPECT_TRUE(meets("X0 Y0"));
    EXPECT_TRUE(meets("X24 Y0"));
    EXPECT_TRUE(meets("X0 Y-19"));
    for (const char* aside : {"X26 Y0", "X-26 Y0", "X0 Y21", "X0 Y-21"})
        EXPECT_FALSE(meets(aside)) << aside;
}

}  // namespace
}  // namespace ncsim::verify_test
