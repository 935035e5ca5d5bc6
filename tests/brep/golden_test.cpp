// SPDX-License-Identifier: GPL-3.0-or-later
//
// Golden parts: each program has known numbers of faces per kind and a known volume, which do not
// depend on the tolerance of the simulated tools.
#include "brep/golden.h"

#include "ncsim/brep/measure.h"

#include "brep/made_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ncsim::brep {
namespace {

using test::Golden;
using test::kBlock;
using test::kinds_of;
using test::kPi;
using test::Made;
using test::make;

// Returns the cross-section (mm²) of the groove of the ball of 8 mm, 3 mm deep. `ball_cap` returns
// the volume (mm³) at the groove's ends.
double ball_section() {
    return 16.0 * std::acos(0.25) - std::sqrt(15.0);
}
double ball_cap() {
    return kPi * 9.0 * (3.0 * 4.0 - 3.0) / 3.0;
}
// Returns the cross-section (mm²) of the groove of the bull nose, 3 mm deep.
double bull_section() {
    return 12.0 * 3.0 - 2.0 * (4.0 - kPi);
}

// Returns the volume (mm³) that the bull nose removes, 2 mm deep, along 29.5 mm and a quarter arc
// of radius 5.5 mm, which is smaller than the tool's radius. Sums the strips, the ends and the
// sector around the corner at each height.
double narrow_corner() {
    const double strips = 59.0 + 5.5 * kPi, round = kPi;  // factors of the radius and of its square
    const double first = 8.0 + kPi, second = 32.0 + 8.0 * kPi + 16.0 / 3.0;
    const double u = std::sqrt(1.75);
    const double beyond =
        4.0 * u - u * u * u / 3.0 - 3.0 * (0.75 * u + 2.0 * std::asin(0.5 * u)) + 2.25 * u;
    return strips * first + round * second - (1.0 - 0.25 * kPi) * beyond;
}

// Returns the area of the disc of radius 30 between -`y` and `y`.
double across_bar(double y) {
    return 2.0 * (y * std::sqrt(900.0 - y * y) + 900.0 * std::asin(y / 30.0));
}

// Returns the volume of a groove of the ball, 20 mm long between two arcs of `reach` mm whose
// centres are 1 mm below the top: outside each arc, a torus and a cylinder above it.
double ball_lead_in(double reach) {
    constexpr double kRadius = 4.0, kLength = 20.0, kAbove = 1.0;
    const double level = 0.5 * kPi * kRadius * kRadius + 2.0 * kRadius * (reach + kAbove);
    const double around =
        0.25 * kPi * kRadius *
        (2.0 * reach * reach + kPi * reach * kRadius + 4.0 / 3.0 * kRadius * kRadius);
    const double above = kAbove * (2.0 * kRadius * reach + 0.5 * kPi * kRadius * kRadius);
    return kLength * level + 2.0 * (around + above);
}

std::vector<Golden> goldens() {
    const double slope = std::tan(59.0 * kPi / 180.0), tip = 3.0 / slope;
    return {
        {"bores",
         "T1 M6\nG0 X45 Y30 Z5\nG1 Z-25\nG3 X45 Y30 I-5 J0\nG0 Z5\nG0 X50 Y30\nG1 Z-5\n"
         "G3 X50 Y30 I-10 J0\nG0 Z5\n",
         {7, 2, 0, 0, 0},
         kBlock - kPi * (100.0 * 20.0 + 125.0 * 5.0)},
        {"slot",
         "T1 M6\nG0 X20 Y30 Z5\nG1 Z-4\nG1 X50\nG0 Z5\n",
         {9, 2, 0, 0, 0},
         kBlock - 4.0 * (300.0 + 25.0 * kPi)},
        // Both moves are one hull, named after the second move; the wall is at the start of the
        // first.
        {"slot_in_two_moves",
         "T1 M6\nG0 X20 Y30 Z5\nG1 Z-4\nG1 X23\nG4 P1\nG1 X28\nG0 Z5\n",
         {9, 2, 0, 0, 0},
         kBlock - 4.0 * (80.0 + 25.0 * kPi)},
        {"slot_askew",
         "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG1 X44 Y27\nG0 Z5\n",
         {9, 2, 0, 0, 0},
         kBlock - 4.0 * (250.0 + 25.0 * kPi)},
        {"arc_slot",
         "T1 M6\nG0 X55 Y20 Z5\nG1 Z-4\nG3 X25 Y20 I-15 J0\nG0 Z5\n",
         {7, 4, 0, 0, 0},
         kBlock - 4.0 * (150.0 * kPi + 25.0 * kPi)},
        {"bent_slot",
         "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG1 X40\nG3 X50 Y30 I0 J10\nG1 Y45\nG0 Z5\n",
         {11, 4, 0, 0, 0},
         kBlock - 4.0 * (350.0 + 10.0 * 10.0 * kPi / 2 + 25.0 * kPi)},
        {"pocket",
         "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG1 X50\nG1 Y35\nG1 X20\nG1 Y20\nG1 Y28\nG1 X50\nG0 Z5\n",
         {11, 4, 0, 0, 0},
         kBlock - 4.0 * (40.0 * 25.0 - (100.0 - 25.0 * kPi))},
        {"chamfer",
         "T5 M6\nG0 X-10 Y-3 Z5\nG1 Z-4\nG1 X90\nG0 Z5\n",
         {7, 0, 0, 0, 0},
         kBlock - 40.0},
        // Two annular grooves whose walls touch in a line: none of the three strips in between
        // exists. The upper floor, which narrows towards the line, is two planes.
        {"touching_rings",
         "T1 M6\nG0 X52 Y30 Z1\nG1 Z-3\nG2 X52 Y30 I-12\nG0 Z5\nG0 X47 Y25\nG1 Z-6\nG2 X47 Y25 "
         "I-7\nG0 Z5\n",
         {10, 3, 0, 0, 0},
         kBlock - 1275.0 * kPi},
        // The wall of 0.4 µm between both annular grooves leaves fins of facets, which are removed.
        {"ring_beside_ring",
         "T1 M6\nG0 X50 Y30 Z1\nG1 Z-4\nG2 X50 Y30 I-10\nG0 Z5\nG0 X60.0004 Y30\nG1 Z-4\nG2 "
         "X60.0004 Y30 I-20.0004\nG0 Z5\n",
         {8, 2, 0, 0, 0},
         kBlock - 4.0 * kPi * (25.0004 * 25.0004 - 25.0)},
        // Each groove splits both walls of the crossing groove, which touch in a point there.
        {"crossing_points",
         "T2 M6\nG0 X20 Y30 Z5\nG1 Z-1\nG1 X60\nG0 Z5\nG0 X40 Y10\nG1 Z-1\nG1 Y50\nG0 Z5\n",
         {14, 0, 4, 0, 0},
         kBlock - (80.0 * slope - 4.0 * slope * slope / 3.0 + 2.0 * kPi * slope * slope / 3.0)},
        {"ball_groove",
         "T3 M6\nG0 X-10 Y30 Z5\nG1 Z-3\nG1 X90\nG0 Z5\n",
         {7, 1, 0, 0, 0},
         kBlock - 80.0 * ball_section()},
        {"short_ball_groove",
         "T3 M6\nG0 X20 Y30 Z5\nG1 Z-3\nG1 X60\nG0 Z5\n",
         {6, 1, 0, 2, 0},
         kBlock - 40.0 * ball_section() - ball_cap()},
        // Four degrees: the lune at the bend would be 2 µm high.
        {"bent_ball_groove",
         "T3 M6\nG0 X20 Y30 Z5\nG1 Z-3\nG1 X40\nG1 X60 Y31.4\nG0 Z5\n",
         {6, 2, 0, 2, 0},
         kBlock - (20.0 + std::sqrt(400.0 + 1.4 * 1.4)) * ball_section() - ball_cap()},
        {"ball_ring",
         "T3 M6\nG0 X55 Y30 Z5\nG1 Z-3\nG2 X55 Y30 I-15 J0\nG0 Z5\n",
         {7, 0, 0, 0, 1},
         kBlock - 30.0 * kPi * ball_section()},
        // Lead-in arcs that are narrower than the ball: spindle tori whose axes are level.
        {"ball_lead_in_narrow",
         "T3 M6\nG0 X40 Y43 Z5\nG1 Z-5\nG19 G2 Y40 Z-8 J-3 K0\nG1 Y20\nG2 Y17 Z-5 J0 K3\n"
         "G17\nG0 Z5\n",
         {8, 3, 0, 0, 2},
         kBlock - ball_lead_in(3.0)},
        {"ball_lead_in_as_wide",
         "T3 M6\nG0 X40 Y44 Z5\nG1 Z-5\nG19 G2 Y40 Z-9 J-4 K0\nG1 Y20\nG2 Y16 Z-5 J0 K4\n"
         "G17\nG0 Z5\n",
         {8, 3, 0, 0, 2},
         kBlock - ball_lead_in(4.0)},
        {"dimple", "T3 M6\nG0 X40 Y30 Z5\nG1 Z-3\nG0 Z5\n", {6, 0, 0, 1, 0}, kBlock - ball_cap()},
        {"bull_groove",
         "T4 M6\nG0 X-10 Y30 Z5\nG1 Z-3\nG1 X90\nG0 Z5\n",
         {10, 2, 0, 0, 0},
         kBlock - 80.0 * bull_section()},
        {"bull_ring",
         "T4 M6\nG0 X55 Y30 Z5\nG1 Z-3\nG2 X55 Y30 I-15 J0\nG0 Z5\n",
         {8, 2, 0, 0, 2},
         kBlock - 30.0 * kPi * bull_section()},
        // The corner radius is larger than a quarter of the diameter: a spindle torus.
        {"thick_bull_groove",
         "(T6 D=10. CR=3. - bull nose end mill)\nT6 M6\nG0 X30 Y30 Z5\nG1 Z-4\nG1 X50\nG0 Z5\n",
         {9, 4, 0, 0, 2},
         kBlock - 20.0 * (22.0 + 4.5 * kPi) - kPi * (55.0 + 9.0 * kPi)},
        // A torus as thick as wide, whose tips are one point.
        {"thick_bull_ring",
         "(T6 D=10. CR=3. - bull nose end mill)\nT6 M6\nG0 X40 Y30 Z5\nG1 Z-4\nG2 X40 Y30 J1\n"
         "G0 Z5\n",
         {7, 1, 0, 0, 1},
         kBlock - kPi * (81.0 + 13.5 * kPi)},
        // A corner that is narrower than the tool. Inside the arc the torus is a spindle torus
        // (minor radius > major radius) and comes to a tip, which is a vertex of its face.
        {"narrow_corner",
         "T4 M6\nG0 X25 Y8 Z5\nG1 Z-2\nG1 X35.5\nG3 X41 Y13.5 I0 J5.5\nG1 Y32.5\nG0 Z5\n",
         {7, 4, 0, 0, 4},
         kBlock - narrow_corner()},
        // The rim of the tool leaves the floor. Each point of the floor is as deep as the rim's
        // last pass.
        {"ramp",
         "T1 M6\nG0 X20 Y30 Z0\nG1 X60 Z-4\nG0 Z5\n",
         {9, 1, 0, 0, 0, 1},
         kBlock - (800.0 + 100.0 * kPi)},
        {"ramp_askew",
         "T1 M6\nG0 X20 Y20 Z0\nG1 X44 Y27 Z-5\nG0 Z5\n",
         {9, 1, 0, 0, 0, 1},
         kBlock - (625.0 + 125.0 * kPi)},
        {"ramp_up",
         "T1 M6\nG0 X20 Y30 Z5\nG1 Z-4\nG1 X60 Z0\nG0 Z5\n",
         {9, 1, 0, 0, 0, 1},
         kBlock - (800.0 + 100.0 * kPi)},
        // The slope is smaller than the deviation of facets of round tools. The tool's disc is the
        // floor at the start.
        {"shallow_ramp",
         "T1 M6\nG0 X20 Y30 Z5\nG1 Z-1.6\nG1 X43 Z-1.44\nG0 Z5\n",
         {9, 2, 0, 0, 0, 1},
         kBlock - (349.6 + 40.0 * kPi)},
        {"ramp_to_and_fro",
         "T1 M6\nG0 X20 Y30 Z0\nG1 X60 Z-2\nG1 X20 Z-4\nG0 Z5\n",
         {9, 2, 0, 0, 0, 1},
         kBlock - (1200.0 + 100.0 * kPi)},
        // A quarter arc down and a quarter arc up, of radius 6 mm, with a level move in between.
        {"dip",
         "T1 M6\nG0 X20 Y30 Z0\nG18 G2 X26 Z-6 I6 K0\nG1 X44\nG2 X50 Z0 I0 K6\nG17\nG0 Z5\n",
         {9, 0, 0, 0, 0, 0, 2},
         kBlock - (1080.0 + 330.0 * kPi)},
        // A single arc down and up; its lowest position leaves the disc.
        {"dip_between",
         "T1 M6\nG0 X20 Y30 Z0\nG18 G2 X32 Z0 I6 K8\nG17\nG0 Z5\n",
         {9, 0, 0, 0, 0, 0, 2},
         kBlock - (50.0 * kPi + 10.0 * (100.0 * std::asin(0.6) - 48.0))},
        {"drill",
         "T2 M6\nG0 X40 Y30 Z5\nG1 Z-10\nG0 Z5\n",
         {6, 1, 1, 0, 0},
         kBlock - 9.0 * kPi * (10.0 - tip + tip / 3.0)},
        // A spiral of ten turns about X leaves a cylinder of radius 50 mm, with its axis along an
        // edge of the block.
        {"spiral_about_an_edge",
         "T1 M6\nG0 X-8 Y0 Z80 A0\nG1 Z50\nG1 X88 A3600\nG0 Z80\n",
         {5, 1, 0, 0, 0},
         40.0 * (20.0 * std::sqrt(2100.0) + 2500.0 * std::asin(0.4))},
        {"bar",
         "T1 M6\nG0 X-40 Y0 Z5\nG1 Z-4\nG1 X40\nG0 Z5\n",
         {6, 1, 0, 0, 0},
         900.0 * kPi * 20.0 - 4.0 * across_bar(5.0),
         true},
    };
}

class GoldenPart : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPart, HasTheFacesOfItsDrawingAtAnyTolerance) {
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = make(GetParam(), tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), GetParam().kinds);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_EQ(made.solid.part.solids.size(), 1U);
        EXPECT_LT(made.solid.part.miss_mm, 1e-9);
        EXPECT_NEAR(volume(made.solid.part), GetParam().volume, 1e-9 * GetParam().volume);
    }
}

INSTANTIATE_TEST_SUITE_P(Recognise, GoldenPart, testing::ValuesIn(goldens()),
                         [](const auto& tested) { return tested.param.name; });

TEST(Recognise, KnowsTheMiddlesOfDomesAndExtrusions) {
    const auto goldens_ = goldens();
    const auto middle_of = [&](const std::string& name) {
        const auto golden = std::ranges::find(goldens_, name, &Golden::name);
        return mass_of(make(*golden, 0.05).solid.part).centroid;
    };
    // Returns the centroid of the block after removal of the volume `cut` with the centroid
    // `middle`.
    const auto left = [](double cut, Vec3 middle) {
        return (1.0 / (kBlock - cut)) * (kBlock * Vec3{40, 30, -10} - cut * middle);
    };
    const double dip = 1080.0 + 330.0 * kPi;
    const Vec3 of_dip = left(dip, {35, 30, -(4680.0 + 450.0 * kPi) / dip});
    EXPECT_NEAR(norm(middle_of("dip") - of_dip), 0.0, 1e-9);
    // Integrals over the width of 10 mm and over the circle at the end: of the depth, of half its
    // square, and of the depth times the path from the start, less the lead of the front over the
    // middle.
    const double ramp = 800.0 + 100.0 * kPi;
    const double squares = 10.0 * 0.005 * 64000.0 / 3.0 + 8.0 * 25.0 * kPi;
    const double ways =
        10.0 * 0.1 * 64000.0 / 3.0 - 0.1 * 800.0 * 12.5 * kPi + 4.0 * 40.0 * 25.0 * kPi;
    const Vec3 of_ramp = left(ramp, {20.0 + ways / ramp, 30, -squares / ramp});
    EXPECT_NEAR(norm(middle_of("ramp") - of_ramp), 0.0, 1e-9);
}

TEST(Recognise, SaysTheSameForAnyNumberOfThreads) {
    const Golden golden = goldens()[4];
    EXPECT_EQ(make(golden, 0.05, 1).step, make(golden, 0.05, 3).step);
}

}  // namespace
}  // namespace ncsim::brep
