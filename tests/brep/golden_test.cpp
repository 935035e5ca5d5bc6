// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts as a machinist would describe them: so many faces of each kind, volumes as on paper, and
// nothing of it depends on how round the simulated tools are.
#include "brep/golden.h"

#include "ncsim/brep/measure.h"
#include "ncsim/cda/boundary.h"

#include "brep/cam_parts.h"
#include "brep/made_part.h"
#include "brep/random_parts.h"
#include "query/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {
namespace {

using test::Golden;
using test::kBlock;
using test::Kinds;
using test::kinds_of;
using test::kPi;
using test::Made;
using test::make;

// Of the ball of 8 mm, 3 deep: across the way, and where it stood.
double ball_section() {
    return 16.0 * std::acos(0.25) - std::sqrt(15.0);
}
double ball_cap() {
    return kPi * 9.0 * (3.0 * 4.0 - 3.0) / 3.0;
}
// Of the bull nose, 3 deep.
double bull_section() {
    return 12.0 * 3.0 - 2.0 * (4.0 - kPi);
}

// Of the bull nose, 2 deep, along 29.5 mm and a quarter of an arc of radius 5.5, nearer to whose
// centre it is wider than that: at each height strips, the ends, and what is around the corner.
double narrow_corner() {
    const double strips = 59.0 + 5.5 * kPi, round = kPi;  // for each mm of radius; its square
    const double first = 8.0 + kPi, second = 32.0 + 8.0 * kPi + 16.0 / 3.0;
    const double u = std::sqrt(1.75);
    const double beyond =
        4.0 * u - u * u * u / 3.0 - 3.0 * (0.75 * u + 2.0 * std::asin(0.5 * u)) + 2.25 * u;
    return strips * first + round * second - (1.0 - 0.25 * kPi) * beyond;
}

// Under the circle of radius 30, from -y to y.
double across_bar(double y) {
    return 2.0 * (y * std::sqrt(900.0 - y * y) + 900.0 * std::asin(y / 30.0));
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
        // Both moves are one hull, named for the second; the wall is where the first one starts.
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
        // Two rings whose walls touch in one line: none of the three strips between is there. The
        // upper floor, which runs out between them, is two planes.
        {"touching_rings",
         "T1 M6\nG0 X52 Y30 Z1\nG1 Z-3\nG2 X52 Y30 I-12\nG0 Z5\nG0 X47 Y25\nG1 Z-6\nG2 X47 Y25 "
         "I-7\nG0 Z5\n",
         {10, 3, 0, 0, 0},
         kBlock - 1275.0 * kPi},
        // Of the wall of 0.4 um between both rings facets leave a fin here and there, which goes.
        {"ring_beside_ring",
         "T1 M6\nG0 X50 Y30 Z1\nG1 Z-4\nG2 X50 Y30 I-10\nG0 Z5\nG0 X60.0004 Y30\nG1 Z-4\nG2 "
         "X60.0004 Y30 I-20.0004\nG0 Z5\n",
         {8, 2, 0, 0, 0},
         kBlock - 4.0 * kPi * (25.0004 * 25.0004 - 25.0)},
        // Each groove parts both walls of the other one, which touch in a point there.
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
        // Four degrees: the lune at the bend would be 2 um high.
        {"bent_ball_groove",
         "T3 M6\nG0 X20 Y30 Z5\nG1 Z-3\nG1 X40\nG1 X60 Y31.4\nG0 Z5\n",
         {6, 2, 0, 2, 0},
         kBlock - (20.0 + std::sqrt(400.0 + 1.4 * 1.4)) * ball_section() - ball_cap()},
        {"ball_ring",
         "T3 M6\nG0 X55 Y30 Z5\nG1 Z-3\nG2 X55 Y30 I-15 J0\nG0 Z5\n",
         {7, 0, 0, 0, 1},
         kBlock - 30.0 * kPi * ball_section()},
        {"dimple", "T3 M6\nG0 X40 Y30 Z5\nG1 Z-3\nG0 Z5\n", {6, 0, 0, 1, 0}, kBlock - ball_cap()},
        {"bull_groove",
         "T4 M6\nG0 X-10 Y30 Z5\nG1 Z-3\nG1 X90\nG0 Z5\n",
         {10, 2, 0, 0, 0},
         kBlock - 80.0 * bull_section()},
        {"bull_ring",
         "T4 M6\nG0 X55 Y30 Z5\nG1 Z-3\nG2 X55 Y30 I-15 J0\nG0 Z5\n",
         {8, 2, 0, 0, 2},
         kBlock - 30.0 * kPi * bull_section()},
        // Around a corner that is narrower than the tool: within the arc the ring is thicker than
        // wide, and comes to a tip, which is a corner of its face.
        {"narrow_corner",
         "T4 M6\nG0 X25 Y8 Z5\nG1 Z-2\nG1 X35.5\nG3 X41 Y13.5 I0 J5.5\nG1 Y32.5\nG0 Z5\n",
         {7, 4, 0, 0, 4},
         kBlock - narrow_corner()},
        // The rim of the tool leaves the floor, which is as deep as where it passed last.
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
        // Less steep than facets of round tools are off: where it starts is the disc.
        {"shallow_ramp",
         "T1 M6\nG0 X20 Y30 Z5\nG1 Z-1.6\nG1 X43 Z-1.44\nG0 Z5\n",
         {9, 2, 0, 0, 0, 1},
         kBlock - (349.6 + 40.0 * kPi)},
        {"ramp_to_and_fro",
         "T1 M6\nG0 X20 Y30 Z0\nG1 X60 Z-2\nG1 X20 Z-4\nG0 Z5\n",
         {9, 2, 0, 0, 0, 1},
         kBlock - (1200.0 + 100.0 * kPi)},
        // In by a quarter of an arc and out by another one: radius 6, and level between.
        {"dip",
         "T1 M6\nG0 X20 Y30 Z0\nG18 G2 X26 Z-6 I6 K0\nG1 X44\nG2 X50 Z0 I0 K6\nG17\nG0 Z5\n",
         {9, 0, 0, 0, 0, 0, 2},
         kBlock - (1080.0 + 330.0 * kPi)},
        // Down and up again in one arc: at its bottom is the disc.
        {"dip_between",
         "T1 M6\nG0 X20 Y30 Z0\nG18 G2 X32 Z0 I6 K8\nG17\nG0 Z5\n",
         {9, 0, 0, 0, 0, 0, 2},
         kBlock - (50.0 * kPi + 10.0 * (100.0 * std::asin(0.6) - 48.0))},
        {"drill",
         "T2 M6\nG0 X40 Y30 Z5\nG1 Z-10\nG0 Z5\n",
         {6, 1, 1, 0, 0},
         kBlock - 9.0 * kPi * (10.0 - tip + tip / 3.0)},
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

// Once around, 4 deep in 30 pi: along the helix the walls and the floor are splines. The disc, 5 in
// radius, is as deep as where it passed last, which is behind.
TEST(Recognise, KnowsTheFloorsOfHelices) {
    for (const std::string turn : {"G2", "G3"}) {
        const Golden golden{
            "helix", "T1 M6\nG0 X55 Y30 Z1\n" + turn + " X55 Y30 Z-3 I-15\nG0 Z5\n", {}, 0.0};
        for (const double tolerance : {0.05, 0.02, 0.0055}) {
            SCOPED_TRACE(turn + " " + std::to_string(tolerance));
            const Made made = make(golden, tolerance);
            EXPECT_EQ(kinds_of(made.solid.part), (Kinds{7, 3, 0, 0, 0, 0, 0, 1}));
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_LT(made.solid.part.miss_mm, 1e-5);
            const double left = kBlock - 412.5 * kPi;
            EXPECT_NEAR(volume(made.solid.part), left, 1e-8 * left);
            const Mass mass = mass_of(made.solid.part);
            EXPECT_NEAR(mass.volume, left, 1e-8 * left);
        }
    }
}

// Three quarters around, 3 deep, by a tool wider than its way: where it stops it stands before a
// wall whose corners are on the floor that came down beside it, though its middle is not. As floor
// it left a cave, of 0.9 mm3.
TEST(Recognise, WallsAreNotTheFloorsThatComeDownToThem) {
    const Made made = test::make_part(
        setup::job_of({"helix_stops.nc",
                       "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n"
                       "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X20 Y0 Z5\nG1 Z-3\n"
                       "G3 X18 Y-2 Z-6 I-2\nG0 Z5\nM30\n"}),
        0.05);
    EXPECT_GT(volume(made.solid.part), cda::volume(made.boundary));
    EXPECT_LT(volume(made.solid.part), 95813.8);
}

// Half around, nearer to the centre by 0.05: what the disc passes is as wide everywhere, along the
// whole way.
TEST(Recognise, KnowsArcsWhoseEndsDifferInRadius) {
    for (const std::string turn : {"G2", "G3"}) {
        const Golden golden{"spiral",
                            "T1 M6\nG0 X60 Y30 Z1\nG1 Z-4\n" + turn + " X20.05 Y30 I-20\nG0 Z5\n",
                            {},
                            0.0};
        const double lead = 0.05 / kPi;
        double length = 0.0;
        constexpr int kSteps = 1000;
        for (int i = 0; i < kSteps; ++i) {
            const double reach = 20.0 - 0.05 * (i + 0.5) / kSteps;
            length += kPi / kSteps * std::sqrt(reach * reach + lead * lead);
        }
        const double left = kBlock - 4.0 * (10.0 * length + 25.0 * kPi);
        for (const double tolerance : {0.05, 0.02, 0.0055}) {
            SCOPED_TRACE(turn + " " + std::to_string(tolerance));
            const Made made = make(golden, tolerance);
            EXPECT_EQ(kinds_of(made.solid.part), (Kinds{7, 2, 0, 0, 0, 0, 0, 0, 2}));
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_LT(made.solid.part.miss_mm, 1e-5);
            EXPECT_NEAR(volume(made.solid.part), left, 1e-8 * left);
            EXPECT_NEAR(mass_of(made.solid.part).volume, left, 1e-8 * left);
        }
    }
}

// Nearly once around, by a tool that is small beside what is left of the turn. As of one that comes
// near to where it started, all of it stayed facets.
TEST(Recognise, KnowsSpiralsOfNearlyATurn) {
    for (const bool is_left : {false, true}) {
        const std::string side = is_left ? "32.18" : "27.82", end = is_left ? "27.82" : "32.18";
        const Golden golden{"turn",
                            "(T6 D=2. CR=0. - flat end mill)\nT6 M6\nG0 X65.9 Y" + side +
                                " Z1\nG1 Z-4\n" + (is_left ? "G3" : "G2") + " X65.5 Y" + end +
                                " I-25.9 J" + (is_left ? "-2.18" : "2.18") + "\nG0 Z5\n",
                            {},
                            0.0};
        const double from = std::hypot(25.9, 2.18), to = std::hypot(25.5, 2.18);
        const double swept = 2.0 * kPi - std::atan2(2.18, 25.9) - std::atan2(2.18, 25.5);
        const double lead = (to - from) / swept;
        double length = 0.0;
        constexpr int kSteps = 1000;
        for (int i = 0; i < kSteps; ++i)
            length += swept / kSteps * std::hypot(from + (to - from) * (i + 0.5) / kSteps, lead);
        const double left = kBlock - 4.0 * (2.0 * length + kPi);
        for (const double tolerance : {0.05, 0.02}) {
            SCOPED_TRACE(golden.moves + std::to_string(tolerance));
            const Made made = make(golden, tolerance);
            EXPECT_EQ(kinds_of(made.solid.part), (Kinds{7, 2, 0, 0, 0, 0, 0, 0, 2}));
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_LT(made.solid.part.miss_mm, 1e-5);
            EXPECT_NEAR(volume(made.solid.part), left, 1e-8 * left);
        }
    }
}

// Over squares of 0.02 mm, what the ball of 8 mm takes out, 6 deep, that passes within `distance`
// of their middles.
template <typename Distance>
double removed_by_ball(const Distance& distance) {
    constexpr double kStep = 0.02;
    double sum = 0.0;
    for (double x = 0.5 * kStep; x < 80.0; x += kStep) {
        for (double y = 0.5 * kStep; y < 60.0; y += kStep) {
            const double d = distance(x, y);
            if (d < 4.0) sum += 2.0 + std::sqrt(16.0 - d * d);
        }
    }
    return sum * kStep * kStep;
}

// Where the way ends, the ball leaves a cap; the pipe of an earlier line, longer, passes through
// its middle by chance. It joined that as if the way did no more than bend there.
TEST(Recognise, KeepsTheBallAtTheEndOfAWay) {
    const Golden golden{
        "hook", "T3 M6\nG0 X35 Y30 Z5\nG1 Z-6\nG1 X45\nG2 X51 Y30 I3 J3\nG0 Z5\n", {}, 0.0};
    const double radius = std::sqrt(18.0);
    const auto distance = [&](double x, double y) {
        const double u = x - 48.0, v = y - 33.0;
        const bool is_below = v < -std::abs(u);  // where the arc is not
        const double ends =
            std::min(std::hypot(x - 45.0, y - 30.0), std::hypot(x - 51.0, y - 30.0));
        const double arc = is_below ? ends : std::abs(std::hypot(u, v) - radius);
        const double line = std::hypot(std::min(x - 35.0, 0.0) + std::max(x - 45.0, 0.0), y - 30.0);
        return std::min(arc, line);
    };
    const Made made = make(golden, 0.05);
    EXPECT_EQ(made.solid.facets_kept, 0U);
    EXPECT_NEAR(volume(made.solid.part), kBlock - removed_by_ball(distance), 0.1);
}

TEST(Recognise, KnowsTheMiddlesOfDomesAndExtrusions) {
    const auto goldens_ = goldens();
    const auto middle_of = [&](const std::string& name) {
        const auto golden = std::ranges::find(goldens_, name, &Golden::name);
        return mass_of(make(*golden, 0.05).solid.part).centroid;
    };
    // From the middle of the block without what was cut, which is `depth` deep in the middle.
    const auto left = [](double cut, Vec3 middle) {
        return (1.0 / (kBlock - cut)) * (kBlock * Vec3{40, 30, -10} - cut * middle);
    };
    const double dip = 1080.0 + 330.0 * kPi;
    const Vec3 of_dip = left(dip, {35, 30, -(4680.0 + 450.0 * kPi) / dip});
    EXPECT_NEAR(cda::norm(middle_of("dip") - of_dip), 0.0, 1e-9);
    // Over the width of 10, and the circle in which it ends: of depth, of half its square, and of
    // depth times the way from the start, less what the front is ahead of the middle.
    const double ramp = 800.0 + 100.0 * kPi;
    const double squares = 10.0 * 0.005 * 64000.0 / 3.0 + 8.0 * 25.0 * kPi;
    const double ways =
        10.0 * 0.1 * 64000.0 / 3.0 - 0.1 * 800.0 * 12.5 * kPi + 4.0 * 40.0 * 25.0 * kPi;
    const Vec3 of_ramp = left(ramp, {20.0 + ways / ramp, 30, -squares / ramp});
    EXPECT_NEAR(cda::norm(middle_of("ramp") - of_ramp), 0.0, 1e-9);
}

// A bore from the side of a bar: its mouth is a spline that closes in itself. It began with steps
// of half a micrometre, and OpenCASCADE, which looks for curves on the bar at even steps of their
// parameter, found it to cross itself.
TEST(Recognise, SplinesThatCloseHaveStepsAsLongAllAround) {
    const std::string moves =
        "T1 M6\nG0 X10 Y12 Z100\nG0 B90\nG0 Z40\nG1 Z15\nG1 Z40\nG0 Z100\nG0 B0\n";
    const Made made = make({"side_bore", moves, {}, 0.0, true}, 0.05);
    EXPECT_EQ(made.solid.facets_kept, 0U);
    const Part& part = made.solid.part;
    int closed = 0;
    for (const Edge& edge : part.edges) {
        const auto* spline = std::get_if<Spline>(&edge.curve);
        if (!spline || edge.from != edge.to) continue;
        ++closed;
        const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
        std::vector<double> steps;
        for (std::size_t i = 0; i + 1 < spline->knots.size(); ++i)
            steps.push_back(cda::norm(track.at(spline->knots[i + 1] / spline->knots.back()) -
                                      track.at(spline->knots[i] / spline->knots.back())));
        const auto [shortest, longest] = std::ranges::minmax(steps);
        EXPECT_GT(shortest, 0.1 * longest);
    }
    EXPECT_EQ(closed, 1);
}

// Points of two grooves as deep as each other, 16 um apart: the cones meet in a hyperbola as sharp
// as a needle. What is far from its end lies behind there, and it was followed the wrong way.
TEST(Recognise, ConesMeetBesideTheirPoints) {
    const std::string program =
        "(T1 D=6. CR=0. TAPER=30deg - chamfer mill)\n(STOCK/BLOCK,20.,12.,3.,-135.,-2.,3.)\n"
        "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X139.4744 Y5.32 Z2\nG1 Z-0.75\nG1 X139.6222 Y5.5551\n"
        "G1 X139.8108 Y5.7589\nG1 X140.0338 Y5.9245\nG1 X140.2834 Y6.0461\nG0 Z2\n"
        "G0 X145.3128 Y5.1426\nG1 Z-0.75\nG1 X144.4198 Y5.7108\nG1 X143.4341 Y6.0965\n"
        "G1 X142.3927 Y6.2853\nG1 X141.3343 Y6.2702\nG1 X140.2987 Y6.0518\nG0 Z2\nM30\n";
    for (const double tolerance : {0.0125, 0.005}) {
        const Made made = test::make_part(setup::job_of({"points.nc", program}), tolerance);
        EXPECT_EQ(made.solid.facets_kept, 0U) << tolerance;
    }
}

// Two arcs that touch but for the rounding of their numbers. What they leave would be circles that
// miss their common corner by almost a micrometre, and cross beside it.
TEST(Recognise, ArcsEndInTheirCorners) {
    const Golden golden{"bends",
                        "T1 M6\nG0 X35 Y11.34 Z5\nG1 Z-4\nG3 X38.66 Y25 I-5 J8.66\n"
                        "G2 X41.588 Y35.93 I6.928 J4\nG0 Z5\n",
                        {},
                        0.0};
    const Made made = make(golden, 0.05);
    EXPECT_EQ(kinds_of(made.solid.part), (Kinds{7, 6, 0, 0, 0}));
    for (const Edge& edge : made.solid.part.edges) {
        const auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle) continue;
        for (const std::uint32_t v : {edge.from, edge.to}) {
            const Vec3 out = made.solid.part.vertices[v] - circle->centre;
            EXPECT_NEAR(cda::norm(out), circle->radius, 2e-7);
        }
    }
}

// An engraver's way goes back along itself but for rounding: between both walls on the one side is
// a strip that looks to the other side, as flat as it is narrow, and has no width where they meet.
TEST(Recognise, StripsWithoutWidthMayLookAnywhere) {
    const std::string text =
        "(T1 D=10. CR=0. TAPER=30deg - chamfer mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n"
        "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X30 Y20 Z5\nG1 Z-1.016\nG1 X21.7065 Y19.6591\n"
        "G1 X19.4082 Y19.143\nG1 X23.5656 Y20.0764\nG0 Z5\nM30\n";
    const auto job = [&] { return setup::job_of({"back.nc", text}); };
    const double left = volume(test::make_part(job(), 0.001).solid.part);
    for (const double tolerance : {0.05, 0.01}) {
        SCOPED_TRACE(tolerance);
        const Made made = test::make_part(job(), tolerance);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_LT(made.solid.part.miss_mm, 1e-3);
        EXPECT_NEAR(volume(made.solid.part), left, 1e-3);
    }
}

// A slot is deepened from its end on, where the way turns by less than a facet is wide: the wall of
// the turn touches the wall of both slots, of which the upper one ends there. So the slit between
// them is shorter on the one side than on the other.
TEST(Recognise, SlitsMayBeLongerOnOneSide) {
    const Golden golden{"deeper_from_here",
                        "T1 M6\nG0 X40 Y45 Z5\nG1 Z-3\nG1 Y30\nG1 X40.06 Y29.9\nG1 X40.14\n"
                        "G1 X40.2 Y30\nG1 Z-6\nG1 X40.14 Y30.1\nG1 X40.06\nG1 X40 Y30\nG1 Y15\n"
                        "G0 Z5\n",
                        {},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    for (const double tolerance : {0.05, 0.02, 0.01}) {
        SCOPED_TRACE(tolerance);
        const Made made = make(golden, tolerance);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_NEAR(volume(made.solid.part), left, 1e-3);
        Part checked = made.solid.part;
        EXPECT_TRUE(check(checked, 1e-6).empty());
    }
}

// Is a facet beside a face of that form?
template <typename Form>
bool has_facet_beside(const Part& part) {
    std::vector<std::vector<std::uint32_t>> beside(part.edges.size());
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const Loop& loop : part.faces[f].loops) {
            for (const EdgeUse& use : loop)
                beside[use.edge].push_back(f);
        }
    }
    return std::ranges::any_of(beside, [&](const auto& faces) {
        bool has_facet = false, has_form = false;
        for (const std::uint32_t f : faces) {
            has_facet = has_facet || part.faces[f].is_facet;
            has_form = has_form || std::holds_alternative<Form>(part.faces[f].surface.form);
        }
        return has_facet && has_form;
    });
}

// A ball on an arc smaller than itself leaves facets in the floor of a ramp that is less steep than
// these are large: readers found their edges on the other side of it, and drew nothing.
TEST(Recognise, FlatRampsHaveNoFacetsBesideThem) {
    const Golden golden{"flat_ramp",
                        "T1 M6\nG0 X15 Y30 Z5\nG1 Z-3\nG1 X65 Z-3.1\nG0 Z5\n"
                        "T3 M6\nG0 X40 Y30 Z5\nG1 Z-5\nG2 X40 Y30 I-1.5 J0\nG0 Z5\n",
                        {},
                        0.0};
    const Made made = make(golden, 0.05);
    EXPECT_GT(made.solid.facets_kept, 0U);
    EXPECT_FALSE(has_facet_beside<Extrusion>(made.solid.part));
}

// Two upright arcs end in one point: where facets are left beside a dome, their corners may lie
// beyond the half of it that is a face, and readers drew nothing.
TEST(Recognise, DomesHaveNoFacetsBesideThem) {
    const Golden golden{"dips_to_a_point",
                        "T1 M6\nG0 X55 Y30 Z5\nG1 Z0\nG18 G3 X40 Z-15 I-15 K0\nG0 Z5\n"
                        "G0 X40 Y45\nG1 Z0\nG19 G2 Y30 Z-15 J-15 K0\nG0 Z5\nG17\n",
                        {},
                        0.0};
    EXPECT_FALSE(has_facet_beside<Dome>(make(golden, 0.05).solid.part));
}

// A wall was a facet, since a move of a tenth of a micrometre left two corners where its loop came
// to one.
TEST(Recognise, CornersThatAreApartByRoundingAreOne) {
    const Made made = test::make_part(
        setup::job_of({"letter.nc",
                       "(T1 D=6. CR=0. TAPER=30deg - chamfer mill)\n"
                       "(STOCK/BLOCK,20.,20.,3.,-40.,5.,3.)\nG21 G90 G17 F300 S5000 M3\nT1 M6\n"
                       "G0 X45.3543 Y5 Z5\nG1 Z-0.75\nY3\nG0 Z5\nX45.3543 Y4.7723\nG1 Z-0.75\n"
                       "X46.2022 Y5.5189\nX46.2021\nX46.5885 Y5.7985\nX47.0209 Y5.9997\n"
                       "G0 Z5\nM30\n"}),
        0.05, 0, true);
    EXPECT_EQ(made.solid.facets_kept, 0U);
    Part checked = made.solid.part;
    EXPECT_TRUE(check(checked, 1e-3).empty());
}

// They had 510, 370 and 163: what is thin gave up its neighbours, and these theirs; and a plane
// that touches itself in one place gave up all that is around it.
TEST(Recognise, WhatFailsInOnePlaceStaysThere) {
    for (const auto& [seed, most] : {std::pair(5117U, 60U), {5066U, 60U}, {5100U, 60U}}) {
        const Made made =
            test::make_part(setup::job_of({"part.nc", test::random_part(seed)}), 0.05);
        EXPECT_LE(made.solid.facets_kept, most) << seed;
    }
}

// They had 3 to 218 facets: where pipes of a ball bend, an edge that goes on from one of their two
// ellipses to the other had no corner; corners that the polyhedron has in the wrong order were
// looked for far away; edges of a tenth of a micrometre were none; what had no width took the walls
// beside it along.
TEST(Recognise, FinishingByABallLeavesNoFacets) {
    for (const std::uint64_t seed :
         {3U, 5U, 7U, 11U, 15U, 19U, 20U, 33U, 43U, 48U, 49U, 52U, 58U}) {
        const Made made = test::make_part(
            setup::job_of({"part.nc", test::random_part(test::kRasters + seed)}), 0.05);
        EXPECT_EQ(made.solid.facets_kept, 0U) << seed;
        EXPECT_EQ(made.solid.shells_kept, 0U) << seed;
    }
}

// A lollipop leaves a ring above the middle of its ball, too, where no face of a ring thicker than
// wide may be: facets stay there, and took all faces along.
TEST(Recognise, FacetsOfLollipopsInNarrowCornersStayThere) {
    const Golden golden{"lollipop",
                        "(T6 D=8. - lollipop mill)\nT6 M6\nG0 X90 Y30 Z-10\nG1 X40\n"
                        "G3 X41.5 Y31.5 I0 J1.5\nG1 Y40\nG0 Y70\nG0 Z20\n",
                        {},
                        0.0};
    const Made made = make(golden, 0.05);
    EXPECT_EQ(kinds_of(made.solid.part)[1], 2);
    EXPECT_LT(made.solid.facets_kept, 60U);
}

// Of these most kept facets where moves in a row go on one as the other.
TEST(Recognise, CamProgramsLeaveNoFacets) {
    for (const std::uint64_t seed : {0U,  1U,  2U,  3U,  4U,  6U,  8U,  11U, 12U, 13U, 14U,
                                     15U, 17U, 19U, 21U, 22U, 23U, 26U, 30U, 32U, 67U, 85U}) {
        const Made made =
            test::make_part(setup::job_of({"part.nc", test::cam_part(test::kCam + seed)}), 0.05);
        EXPECT_EQ(made.solid.facets_kept, 0U) << seed;
    }
}

// Nothing was drawn of a floor whose outline a deeper pocket touches from inside, along an arc of
// both: it becomes two, on both sides of a line.
TEST(Recognise, PlanesArePartedWhereAHoleTouchesTheirOutline) {
    const auto corners_of = [](const Part& part, const Loop& loop) {
        std::vector<std::uint32_t> corners;
        for (const EdgeUse& use : loop)
            corners.push_back(use.is_forward ? part.edges[use.edge].from : part.edges[use.edge].to);
        std::ranges::sort(corners);
        return corners;
    };
    const Made made = test::make_part(setup::job_of({"part.nc", test::random_part(80857)}), 0.05);
    Part part = made.solid.part;
    EXPECT_EQ(made.solid.facets_kept, 0U);
    EXPECT_EQ(part.faces.size(), 35U);
    EXPECT_TRUE(check(part, 1e-3).empty());
    for (const Face& face : part.faces) {
        for (std::size_t hole = 1; hole < face.loops.size(); ++hole) {
            std::vector<std::uint32_t> common;
            std::ranges::set_intersection(corners_of(part, face.loops.front()),
                                          corners_of(part, face.loops[hole]),
                                          std::back_inserter(common));
            EXPECT_TRUE(common.empty());
        }
    }
}

// Neither the floor's outline nor its hole has another corner than the one where they touch, so a
// round edge of each is halved.
TEST(Recognise, PlanesArePartedWhereRoundEdgesTouch) {
    Made made = test::make_part(
        "ring", "T1 M6\nG0 X30 Y30 Z5\nG1 Z-4\nG3 X30 Y30 I10 J0\nG1 Z-8\nG1 X38\nG0 Z5\n");
    EXPECT_EQ(made.solid.facets_kept, 0U);
    EXPECT_TRUE(check(made.solid.part, 1e-6).empty());
    const auto is_floor = [](const Face& face) {
        const auto* plane = std::get_if<Plane>(&face.surface.form);
        return plane && plane->normal.z > 0.5 && std::abs(plane->origin.z + 4.0) < 1e-6;
    };
    EXPECT_EQ(std::ranges::count_if(made.solid.part.faces, is_floor), 2);
    for (const Face& face : made.solid.part.faces)
        EXPECT_TRUE(!is_floor(face) || face.loops.size() == 1);
}

TEST(Recognise, SaysTheSameForAnyNumberOfThreads) {
    const Golden golden = goldens()[4];
    EXPECT_EQ(make(golden, 0.05, 1).step, make(golden, 0.05, 3).step);
}

// Where a flat end that turns goes level no finer cut helps, nor beside it: none is asked for.
TEST(Recognise, FacetsBesideThoseOfATurningToolAreNotGivenUp) {
    const test::Made turning = test::make_part(
        "turning", "T1 M6\nG0 X-10 Y30 Z20\nG1 Z-4\nG1 X20\nG1 X60.48 Y33 Z4.54 B10\nG0 Z60\n");
    EXPECT_GT(turning.solid.facets_kept, 20U);
    EXPECT_EQ(turning.solid.facets_given_up, 0U);
}

// A slot along a cubic spline has walls of cylinders, since it is taken as arcs within 2 um: as
// wide as the tool along all of its length, and a round end.
TEST(Recognise, KnowsSlotsAlongSplines) {
    const auto length = [] {
        constexpr int kSteps = 100'000;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double t = (i + 0.5) / kSteps, r = 1.0 - t;
            const double x = 3.0 * (20.0 * r * r + 20.0 * t * t), y = 3.0 * 2.0 * r * t * 20.0;
            sum += std::hypot(x, y) / kSteps;
        }
        return sum;
    };
    for (const double tolerance : {0.05, 0.02}) {
        SCOPED_TRACE(tolerance);
        const Made made = make(
            {"spline", "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG5 X60 Y40 I20 J0 P-20 Q0\nG0 Z5\n", {}, 0.0},
            tolerance);
        const Kinds kinds = kinds_of(made.solid.part);
        EXPECT_EQ(kinds[0], 7);
        EXPECT_GT(kinds[1], 10);
        EXPECT_EQ(static_cast<std::size_t>(kinds[0] + kinds[1]), made.solid.part.faces.size());
        EXPECT_EQ(made.solid.facets_kept, 0U);
        const double left = kBlock - 4.0 * (10.0 * length() + kPi * 25.0);
        EXPECT_NEAR(volume(made.solid.part), left, 0.01);
    }
}

// A spline of the first degree has a corner, in which the tool leaves what is round.
TEST(Recognise, KnowsCornersOfSplines) {
    const Golden golden{"corner",
                        "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG5.2 P1 L2\nX40 Y20 P1\nX40 Y40 P1\nG5.3\n"
                        "G0 Z5\n",
                        {11, 3},
                        0.0};
    // Two rectangles that have a corner in common, two half circles, a quarter of one.
    const double left = kBlock - 4.0 * (2.0 * 20.0 * 10.0 - 5.0 * 5.0 + 1.25 * kPi * 25.0);
    expect_at({0.05, 0.02, 0.0055}, golden, left, 1e-9);
}

}  // namespace
}  // namespace ncsim::brep
