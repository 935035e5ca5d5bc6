// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts with envelopes: as golden ones, their volumes by sums over squares where no paper has them.
#include "ncsim/brep/curve.h"
#include "ncsim/brep/measure.h"
#include "ncsim/brep/swept.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "brep/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {
namespace {

using test::expect_at;
using test::Golden;
using test::kBlock;
using test::Kinds;
using test::kinds_of;
using test::kPi;
using test::Made;
using test::make;

// Of the smallest value of what goes down first and then up, between both ends.
template <typename F>
double least_of(const F& f, double low, double high) {
    constexpr int kThirds = 90;
    for (int i = 0; i < kThirds; ++i) {
        const double third = (high - low) / 3.0;
        if (f(low + third) < f(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return f(0.5 * (low + high));
}

// How high the bull nose is there, from its middle.
double bull_height(double x, double y) {
    const double out = std::max(0.0, std::hypot(x, y) - 4.0);
    return 2.0 - std::sqrt(std::max(0.0, 4.0 - out * out));
}

// Down a slope from side to side of the block, 0.06 mm for 1 mm, the corner radius leaves one face.
TEST(Recognise, KnowsTheFloorsOfBullNosesOnSlopes) {
    const Golden golden{"slope", "T4 M6\nG0 X-10 Y30 Z0\nG1 X90 Z-6\nG0 Z5\n", {}, 0.0};
    // At y beside the way the floor is so much higher than a line that goes down with the tip.
    double cut = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = kPi * ((i + 0.5) / kSteps - 0.5), y = 6.0 * std::sin(angle);
        const double half = std::sqrt(36.0 - y * y);
        const double higher =
            least_of([&](double x) { return bull_height(x, y) + 0.06 * x; }, -half, half);
        const auto depth = [&](double x) { return std::max(0.0, 0.06 * (x + 10.0) - higher); };
        const double area = (depth(80.0) * depth(80.0) - depth(0.0) * depth(0.0)) / 0.12;
        cut += kPi / kSteps * half * area;
    }
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = make(golden, tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{9, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_LT(made.solid.part.miss_mm, 1e-5);
        EXPECT_NEAR(volume(made.solid.part), kBlock - cut, 1e-8 * kBlock);
        EXPECT_NEAR(mass_of(made.solid.part).volume, kBlock - cut, 1e-8 * kBlock);
    }
}

// Steep, and ending in the block: beside the floor stands the tool, with its side, its corner
// radius all around and its flat end.
TEST(Recognise, KnowsWhereBullNosesStopOnSlopes) {
    const Golden golden{"steep", "T4 M6\nG0 X20 Y30 Z0\nG1 X40 Z-12\nG0 Z5\n", {}, 0.0};
    double cut = 0.0;
    constexpr double kStep = 0.1;
    for (double x = 0.5 * kStep; x < 80.0; x += kStep) {
        for (double y = 0.5 * kStep; y < 30.0; y += kStep) {
            const double beside = y - 30.0;
            if (beside <= -6.0) continue;
            const double half = std::sqrt(36.0 - beside * beside);
            const double from = std::max(20.0, x - half), to = std::min(40.0, x + half);
            if (from >= to) continue;
            const auto floor = [&](double at) {
                return bull_height(x - at, beside) - 0.6 * (at - 20.0);
            };
            cut += 2.0 * kStep * kStep * std::max(0.0, -least_of(floor, from, to));
        }
    }
    const double left = volume(make(golden, 0.002).solid.part);
    EXPECT_NEAR(left, kBlock - cut, 0.5);
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = make(golden, tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{9, 1, 0, 0, 1, 0, 0, 0, 0, 1}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_LT(made.solid.part.miss_mm, 1e-5);
        EXPECT_NEAR(volume(made.solid.part), left, 1e-8 * left);
    }
}

// What the ball of 8 mm takes out on a helix about the middle, its radius 15, from Z1 on: over
// squares, at the times about the angle of each.
double removed_on_helix(double down, double turns) {
    constexpr double kStep = 0.1, kTime = 5e-4;
    double sum = 0.0;
    for (double x = 20.0 + 0.5 * kStep; x < 60.0; x += kStep) {
        for (double y = 10.0 + 0.5 * kStep; y < 50.0; y += kStep) {
            double depth = 0.0;
            const double u = x - 40.0, v = y - 30.0, away = std::hypot(u, v);
            if (std::abs(away - 15.0) >= 4.0) continue;
            const double at = std::atan2(v, u) / (2.0 * kPi);
            for (double middle = at - 1.0; middle < turns + 1.0; middle += 1.0) {
                for (double t = std::max(0.0, middle - 0.05); t < std::min(turns, middle + 0.05);
                     t += kTime) {
                    const double d = std::hypot(u - 15.0 * std::cos(2.0 * kPi * t),
                                                v - 15.0 * std::sin(2.0 * kPi * t));
                    if (d < 4.0) depth = std::max(depth, down * t - 5.0 + std::sqrt(16.0 - d * d));
                }
            }
            sum += kStep * kStep * depth;
        }
    }
    return sum;
}

// A whole turn is two halves, which are one groove but for their edge; at the end stands the ball.
TEST(Recognise, KnowsTheGroovesOfBallsOnHelices) {
    struct Helix {
        std::string moves;
        double turns;
        Kinds kinds;
    };
    const std::string start = "T3 M6\nG0 X55 Y30 Z1\n";
    for (const auto& [moves, turns, kinds] :
         {Helix{"G3 X25 Y30 Z-1 I-15\n", 0.5, {6, 0, 0, 1, 0, 0, 0, 0, 0, 1}},
          Helix{"G3 X55 Y30 Z-3 I-15\n", 1.0, {6, 0, 0, 1, 0, 0, 0, 0, 0, 2}}}) {
        const Golden golden{"groove", start + moves + "G0 Z5\n", kinds, 0.0};
        const double cut = removed_on_helix(4.0, turns);
        const double left = volume(make(golden, 0.004).solid.part);
        EXPECT_NEAR(left, kBlock - cut, 4e-3 * cut) << moves;
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02, 0.0055}, golden, left);
    }
}

// While B turns about the zero, X and Z are told so that the tip goes about level through the top
// of the block; and a chain of such moves, which bends by so little that the lunes between are left
// out.
TEST(Recognise, KnowsTheGroovesOfBallsThatTurn) {
    const std::string start = "T3 M6\nG0 X20 Y30 Z20\nG1 Z-2\n", end = "G0 Z60\n";
    for (const auto& [moves, kinds] :
         {std::pair<std::string, Kinds>{"G1 X60 Z7.4 B10\n", {6, 0, 0, 2, 0, 0, 0, 0, 0, 1}},
          {"G1 X30 Z-0.7 B2\nG1 X40 Y30.3 Z0.7 B4\nG1 X50 Y30 Z3 B6\n",
           {6, 0, 0, 2, 0, 0, 0, 0, 0, 3}}}) {
        const Golden golden{"turning", start + moves + end, kinds, 0.0};
        const double left = volume(make(golden, 0.01).solid.part);
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02}, golden, left);
    }
}

// The same deeper than the ball is high, down and up along the tool. Turned in the plane of its way
// its side leaves planes; beside that, to the left and to the right, what no other form is. A chain
// bends by 3 degrees, or by 11, where faces of the ball cross in a curve that passes where they
// touch.
TEST(Recognise, KnowsTheSidesOfBallsThatTurn) {
    const std::string start = "T3 M6\nG0 X20 Y30 Z20\nG1 Z-8\n", end = "G0 Z60\n";
    for (const auto& [moves, kinds] :
         {std::pair<std::string, Kinds>{"G1 X60.48 Z2.54 B10\n", {8, 2, 0, 2, 0, 0, 0, 0, 0, 1}},
          {"G1 X60.48 Y36 Z2.54 B10\n", {6, 2, 0, 2, 0, 0, 0, 0, 0, 3}},
          {"G1 X40.88 Y31 Z-5.18 B4\nG1 X60.48 Y33 Z2.54 B10\n", {6, 2, 0, 2, 0, 0, 0, 0, 0, 6}},
          {"G1 X40.88 Y31 Z-5.18 B4\nG1 X60.48 Y36 Z2.54 B10\n", {6, 2, 0, 2, 0, 0, 0, 0, 0, 6}}}) {
        const Golden golden{"side", start + moves + end, kinds, 0.0};
        const double left = volume(make(golden, 0.025).solid.part);
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02}, golden, left);
    }
}

// Where such a slope is nearly level, what is left of the ring around the flat end where the tool
// stood is a hundredth of a millimetre high, and no facet tells it.
TEST(Recognise, KnowsWhereBullNosesStopNearlyLevel) {
    const std::string start = "T4 M6\nG0 X20 Y30 Z0\n", end = "G0 Z5\n";
    for (const auto& [moves, kinds] :
         {std::pair<std::string, Kinds>{"G1 X60 Z-2\n", {7, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
          {"G1 X40 Z-1\nG1 X60 Y40 Z-2\n", {7, 0, 0, 0, 2, 0, 0, 0, 0, 2}}}) {
        const Golden golden{"level", start + moves + end, kinds, 0.0};
        const double left = volume(make(golden, 0.002).solid.part);
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02, 0.0055}, golden, left);
    }
}

// Strips of such rings that cannot stay are not put in again and again.
TEST(Recognise, EndsWhereBullNosesGoDownAndLevelInTurns) {
    const Golden golden{"turns",
                        "T4 M6\nG0 X20 Y30 Z5\nG1 Z-1\nG1 X25 Z-1.05\nG1 X30\nG1 X35 Z-1.2\n"
                        "G1 X40 Z-1.1\nG0 Z5\n",
                        {},
                        0.0};
    const Made made = make(golden, 0.05);
    EXPECT_EQ(made.solid.part.solids.size(), 1U);
    EXPECT_TRUE(made.solid.is_sound);
}

// Down, up, and in a chain, with what their sides leave: its flat end goes level nowhere.
TEST(Recognise, KnowsTheCornersOfBullNosesThatTurn) {
    const std::string start = "T4 M6\nG0 X20 Y30 Z20\n", end = "G0 Z60\n";
    for (const auto& [moves, kinds] :
         {std::pair<std::string, Kinds>{"G1 Z-5\nG1 X55 Y33 Z-6 B3\n",
                                        {7, 2, 0, 0, 2, 0, 0, 0, 0, 3}},
          {"G1 Z-8\nG1 X60.48 Y33 Z3.5 B10\n", {7, 2, 0, 0, 2, 0, 0, 0, 0, 3}},
          {"G1 Z-8\nG1 X40.88 Y31 Z-4.5 B2\nG1 X60.48 Y33 Z2 B5\n",
           {7, 2, 0, 0, 2, 0, 0, 0, 0, 6}}}) {
        const Golden golden{"bull", start + moves + end, kinds, 0.0};
        const double left = volume(make(golden, 0.025).solid.part);
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02}, golden, left);
    }
}

// The circle of a flat end: at both ends of the way it is an edge.
TEST(Recognise, KnowsTheRimsOfFlatEndsThatTurn) {
    const Golden golden{"rim",
                        "T1 M6\nG0 X20 Y30 Z20\nG1 Z-5\nG1 X55 Y33 Z-6 B3\nG0 Z60\n",
                        {7, 2, 0, 0, 0, 0, 0, 0, 0, 3},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.0055}, golden, left);
}

// An arc nearer to its centre where it ends, and a helix in an upright plane.
TEST(Recognise, KnowsTheGroovesOfBallsOnOtherArcs) {
    for (const auto& [moves, kinds] :
         {std::pair<std::string, Kinds>{"T3 M6\nG0 X60 Y30 Z1\nG1 Z-3\nG3 X20.05 Y30 I-20\n",
                                        {6, 0, 0, 2, 0, 0, 0, 0, 0, 1}},
          {"T3 M6\nG0 X25 Y25 Z1\nG1 Z-2\nG18 G3 X55 Y35 Z-2 I15 K30\nG17\n",
           {6, 0, 0, 2, 0, 0, 0, 0, 0, 2}}}) {
        const Golden golden{"arc", moves + "G0 Z5\n", kinds, 0.0};
        const double left = volume(make(golden, 0.004).solid.part);
        SCOPED_TRACE(moves);
        expect_at({0.05, 0.02, 0.0055}, golden, left);
    }
}

// A corner radius on an arc hardly wider than itself: its envelope folds, and edges of its face go
// along the fold, where some of their points are in no place of it. What faces bound has the area
// of their edges, seen from any side; so the volume is the same from wherever it is summed up.
TEST(Envelope, AreasAreKnownWhereItFolds) {
    simulation::Plan plan;
    plan.job = setup::job_of(
        {"fold.nc",
         "(T4 D=12. CR=2. - bull nose end mill)\n(STOCK/BLOCK,60.,50.,15.,-30.,5.,15.)\n"
         "G21 G90 G17 F300 S5000 M3\nT4 M6\nG0 X39.698 Y5.769 Z5\nG1 Z-6.016\n"
         "G1 X56.396 Y5.769 Z-4.604\nG2 X50.695 Y11.470 Z-6.647 I-5.701 J0\n"
         "G1 X51.163 Y30.374 Z-1.182\nG0 Z5\nM30\n"});
    plan.keep_boundary = true;
    const simulation::Survey survey = simulation::survey(plan);
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    const Recognised solid = simulation::solid_of(plan, survey, milled, 1e-6);
    ASSERT_EQ(solid.facets_kept, 0);
    const Part& part = solid.part;
    const auto three = [&](const Face& face, Vec3 apex) {
        return 3.0 * measure(part, face, apex).volume;
    };
    int envelopes = 0;
    for (const Face& face : part.faces) {
        if (!std::holds_alternative<brep::Envelope>(face.surface.form)) continue;
        ++envelopes;
        Vec3 of_edges;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const Edge& edge = part.edges[use.edge];
                const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
                constexpr int kSteps = 20'000;
                for (int i = 0; i < kSteps; ++i) {
                    const Vec3 from = track.at(double(i) / kSteps);
                    const Vec3 to = track.at(double(i + 1) / kSteps);
                    of_edges = of_edges + (use.is_forward ? 0.5 : -0.5) *
                                              cda::cross(from - part.vertices[0], to - from);
                }
            }
        }
        const double here = three(face, {});
        const Vec3 area{here - three(face, {1, 0, 0}), here - three(face, {0, 1, 0}),
                        here - three(face, {0, 0, 1})};
        EXPECT_LT(cda::norm(area - of_edges), 2e-3);
    }
    EXPECT_EQ(envelopes, 6);
}

// Each of 300 turns was two surfaces to try, for each facet: a line of 40 characters took a minute.
TEST(Envelope, ManyTurnsAreFewSurfaces) {
    const setup::Job job =
        setup::job_of({"bore.nc",
                       "(T3 D=8. CR=4. - ball end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n"
                       "G21 G90 G17 F300 S5000 M3\nT3 M6\nG0 X50 Y30 Z0\n"
                       "G2 X50 Y30 Z-18 I-10 P300\nM30\n"});
    simulation::Plan plan;
    plan.job = job;
    const simulation::Survey survey = simulation::survey(plan);
    int arcs = 0;
    gcode::interpret(job.program, job.interpreter, [&](const gcode::Motion& motion) {
        if (!std::holds_alternative<gcode::Arc>(motion.what)) return;
        ++arcs;
        const Source source = surfaces_of(motion, survey.tools.at(motion.tool).tool, nullptr);
        const auto envelopes = std::ranges::count_if(source.candidates, [](const Candidate& c) {
            return std::holds_alternative<brep::Envelope>(c.surface.form);
        });
        EXPECT_GT(envelopes, 0);
        EXPECT_LE(envelopes, 8);
        EXPECT_TRUE(source.may_leave_other_surfaces);
    });
    EXPECT_EQ(arcs, 1);
}

}  // namespace
}  // namespace ncsim::brep
