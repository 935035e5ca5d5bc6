// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts of shanks, holders and non-cutting cores with the part, and contacts with fixtures. Each
// rule has a program that violates the rule at a known line by a known amount, a program that just
// keeps the rule, and a program for which the rule cannot be checked.
#include "verify/expected.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace ncsim::verify_test {
namespace {

using verify::Certainty;
using verify::Finding;
using verify::Severity;

TEST(NonCuttingContact, IsFoundWithTheStickOutThatIsMissing) {
    // The shank begins 5 mm above the tip: at depth 8 mm the shank is 3 mm deep in material.
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
    // The shank follows the path of the cutter; the holder, 30 mm above the tip, comes down to the
    // block.
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
    // The polygon of a ball differs from the polygon of a cylinder with the same diameter. With
    // separate polygons, corners of the shank would extend beyond the ball at any tolerance.
    for (toolpath::Tool tool :
         {toolpath::ball_end_mill(5.188, 3.0), toolpath::bull_nose_end_mill(5.188, 1.297, 3.0),
          toolpath::bull_nose_end_mill(9.2456, 1.53924, 4.3434)}) {
        toolpath::add_holder_segment(tool, 2 * tool.pieces[0].profile.back().radius,
                                     2 * tool.pieces[0].profile.back().radius, 20.0);
        verify::Setup setup = plain_setup();
        setup.tools.at(1).tool = tool;
        const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-9\nG1 Z5\n", setup);
        EXPECT_TRUE(findings_of(verdict, "non-cutting-contact").empty());
        // The shank still does not cut: in the sideways move the shank must be above the rest of
        // the block.
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
              "neither flute length, shank nor holder is specified for T1");
}

TEST(Plunge, IsFoundForToolsThatDoNotCutAtTheirCentre) {
    verify::Setup setup = plain_setup();
    setup.tools.at(1).blind_diameter = 4.0;
    const auto verdict = verdict_of(kStart + "G0 X0\nG1 Z-2\n", setup);
    const Finding f = only(verdict, "plunge");
    expect_at(f, 3, 2.0, 0.0101);
}

TEST(Plunge, IsFoundHoweverLittleItGoesAside) {
    // A plunge of 1 µm; a helix of diameter 1 mm; a ramp of 30 degrees; a reciprocating move
    // shorter than the core.
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
    // Only the rim extends over the edge of the block; then a ramp.
    const std::string program = "G0 X-22\nG1 Z-2\nG1 X10 Z-4\nG0 Z5\n";
    EXPECT_TRUE(findings_of(verdict_of(kStart + program, setup), "plunge").empty());
    EXPECT_TRUE(findings_of(verdict_of(kStart + "G0 X0\nG1 Z-2\n"), "plunge").empty());
}

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
    // The holder begins 30 mm above the tip and extends 20 mm sideways; the jaw ends at Z5.
    const auto clear = verdict_of(kStart + "G0 Y0 Z-25\n", with_jaw(0));
    EXPECT_TRUE(findings_of(clear, "fixture-contact").empty());
    const auto verdict = verdict_of(kStart + "G0 Y0 Z-25.1\n", with_jaw(0));
    const auto found = findings_of(verdict, "fixture-contact");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "shank or holder of T1 meets the fixture 'jaw'");
}

TEST(FixtureClearance, IsAnErrorOfItsOwn) {
    const auto verdict = verdict_of(kStart + "G0 Y9 Z-2\nG1 X30\nG0 Y8\n", with_jaw(1.5));
    const auto found = findings_of(verdict, "fixture-clearance");
    ASSERT_EQ(found.size(), 2U) << "the cutter, and the shank above it";
    const Finding& f = found.front();
    EXPECT_EQ(f.place.span.line, 2U);
    EXPECT_EQ(f.severity, Severity::Error);
    EXPECT_TRUE(findings_of(verdict, "fixture-contact").empty());
    const auto far = verdict_of(kStart + "G0 Y8.5 Z-2\nG1 X30\n", with_jaw(1.5));
    EXPECT_TRUE(findings_of(far, "fixture-clearance").empty());
}

TEST(FixtureContact, IsNotFoundWhereAConeOnlyTouches) {
    // Rounding moves the planes of the cone outwards, by less than the fixture check detects.
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

// Returns the set-up with the jaw as a closed triangle mesh.
verify::Setup with_jaw_of_triangles(double clearance) {
    verify::Setup setup = with_jaw(clearance);
    TriangleMesh& mesh = setup.machine.fixtures[0].mesh;
    const Box b = setup.machine.fixtures[0].box;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                                 (i & 4) != 0 ? b.max.z : b.min.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return setup;
}

TEST(FixtureContact, IsFoundForAMesh) {
    const verify::Setup setup = with_jaw_of_triangles(0);
    const auto verdict = verdict_of(kStart + "G0 Y9.9 Z-2\nG1 X30\nG1 Y10.1\n", setup);
    const auto found = findings_of(verdict, "fixture-contact");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].place.span.line, 4U);
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    const auto clear = verdict_of(kStart + "G0 Y10 Z-2\nG1 X30\n", setup);
    EXPECT_TRUE(findings_of(clear, "fixture-contact").empty());
}

// Triangles of a STEP file are inside a convex curved surface. A contact in the gap is possible; a
// contact with the triangles is certain only if the contact is deeper than the gap.
TEST(FixtureContact, IsOpenWhereTrianglesHideTheSurface) {
    verify::Setup setup = with_jaw_of_triangles(0);
    setup.machine.fixtures[0].deflection_mm = 0.01;
    const auto certainty_at = [&](double y) -> std::optional<Certainty> {
        const auto verdict = verdict_of(kStart + fmt::format("G0 Y{} Z-2\nG1 X30\n", y), setup);
        const auto found = findings_of(verdict, "fixture-contact");
        if (found.empty()) return std::nullopt;
        return found[0].certainty;
    };
    EXPECT_EQ(certainty_at(9.985), std::nullopt);
    EXPECT_EQ(certainty_at(9.995), Certainty::Within);
    EXPECT_EQ(certainty_at(10.005), Certainty::Within);
    EXPECT_EQ(certainty_at(10.015), Certainty::Certain);
}

TEST(FixtureClearance, IsOpenWhereTrianglesHideTheSurface) {
    verify::Setup setup = with_jaw_of_triangles(1.5);
    setup.machine.fixtures[0].deflection_mm = 0.01;
    const auto certainty_at = [&](double y) -> std::optional<Certainty> {
        const auto verdict = verdict_of(kStart + fmt::format("G0 Y{} Z-2\nG1 X30\n", y), setup);
        EXPECT_TRUE(findings_of(verdict, "fixture-contact").empty());
        const auto found = findings_of(verdict, "fixture-clearance");
        if (found.empty()) return std::nullopt;
        return found[0].certainty;
    };
    EXPECT_EQ(certainty_at(8.485), std::nullopt);
    EXPECT_EQ(certainty_at(8.495), Certainty::Within);
    EXPECT_EQ(certainty_at(8.515), Certainty::Certain);
}

}  // namespace
}  // namespace ncsim::verify_test
