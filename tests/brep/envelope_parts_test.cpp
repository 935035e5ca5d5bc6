// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts with envelopes, tested like golden parts. Volumes without a closed form are sums over
// squares.
#include "ncsim/base/angles.h"
#include "ncsim/brep/curve.h"
#include "ncsim/brep/measure.h"
#include "ncsim/brep/patch.h"
#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "brep/golden.h"
#include "geometry/spline_surface.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
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

// Returns the minimum of `f` between `low` and `high`, by ternary search.
// Requires: `f` first decreases and then increases.
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

// Returns the height (mm) of the bull nose D12 R2 above its tip at (`x`, `y`) from its axis.
double bull_height(double x, double y) {
    const double out = std::max(0.0, std::hypot(x, y) - 4.0);
    return 2.0 - std::sqrt(std::max(0.0, 4.0 - out * out));
}

// Along a slope of 6 % from side to side of the block, the corner radius leaves a single face.
TEST(Recognise, KnowsTheFloorsOfBullNosesOnSlopes) {
    const Golden golden{"slope", "T4 M6\nG0 X-10 Y30 Z0\nG1 X90 Z-6\nG0 Z5\n", {}, 0.0};
    // At lateral distance `y`, the floor is `higher` mm above the line on which the tip descends.
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

// A steep slope ends within the block. There the tool leaves its side, its corner radius all around
// and its flat end.
TEST(Recognise, KnowsWhereBullNosesStopOnSlopes) {
    const Golden golden{"steep", "T4 M6\nG0 X20 Y30 Z0\nG1 X40 Z-12\nG0 Z5\n", {}, 0.0};
    double cut = 0.0;
    constexpr double kStep = 0.1;
    for (double x = 0.5 * kStep; x < 80.0; x += kStep) {
        for (double y = 0.5 * kStep; y < 30.0; y += kStep) {
            const double lateral = y - 30.0;
            if (lateral <= -6.0) continue;
            const double half = std::sqrt(36.0 - lateral * lateral);
            const double from = std::max(20.0, x - half), to = std::min(40.0, x + half);
            if (from >= to) continue;
            const auto floor = [&](double at) {
                return bull_height(x - at, lateral) - 0.6 * (at - 20.0);
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

// Returns the volume (mm³) that the ball of 8 mm removes on a helix about the middle of the block,
// of radius 15 mm, from Z1 on, `down` mm per turn. Sums over squares; each square takes only the
// times near its angle.
double removed_on_helix(double down, double turns) {
    constexpr double kStep = 0.1, kTime = 5e-4;
    double sum = 0.0;
    for (double x = 20.0 + 0.5 * kStep; x < 60.0; x += kStep) {
        for (double y = 10.0 + 0.5 * kStep; y < 50.0; y += kStep) {
            double depth = 0.0;
            const double u = x - 40.0, v = y - 30.0, radius = std::hypot(u, v);
            if (std::abs(radius - 15.0) >= 4.0) continue;
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

// A full turn is two half turns, whose faces are the same groove but for the edge between. The ball
// leaves a spherical cap at the end.
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

// While B rotates about the zero, X and Z are such that the tip moves nearly level through the top
// of the block. The second case is a chain of moves that bends so little that the lunes in between
// are omitted.
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

// Moves as above, deeper than the ball is high, with entry and exit along the tool. A tool that
// rotates in the plane of its path leaves planes with its side; with lateral motion the side leaves
// envelopes. Chains bend by 3 or by 11 degrees; at 11 degrees, faces of the ball cross in a curve
// that passes through their point of contact.
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

// Returns moves down a quarter of a helix into a level line at `depth`, and up again.
std::string lead_in_and_out(double reach, double down, double depth) {
    return fmt::format(
        "T3 M6\nG0 X{} Y{} Z5\nG1 Z{}\nG3 X25 Y30 Z{} I{} J0\nG1 X55\n"
        "G3 X{} Y{} Z{} I0 J{}\nG0 Z5\n",
        25.0 - reach, 30.0 + reach, down - depth, -depth, reach, 55.0 + reach, 30.0 + reach,
        down - depth, reach);
}

// A ball goes down a quarter of a helix into a level line. Both surfaces meet twice at an angle of
// a few degrees; one place is beyond the end of the helix. The lune of the ball between them is
// left out, and its depth is reported.
TEST(Recognise, KnowsHelicalLeadInsOfBalls) {
    for (const double reach : {5.0, 8.0}) {
        for (const double down : {0.2, 1.0, 2.0}) {
            SCOPED_TRACE(testing::Message() << reach << ", " << down);
            const std::string moves = lead_in_and_out(reach, down, 3.0);
            for (const double tolerance : {0.05, 0.02}) {
                const Made made = make({"lead-in", moves, {}, 0.0}, tolerance);
                // With facets small enough, a lune may be there: a third sphere.
                Kinds kinds = kinds_of(made.solid.part);
                const int spheres = std::exchange(kinds[3], 0);
                EXPECT_TRUE(spheres >= 2 && spheres < 4) << spheres;
                EXPECT_EQ(kinds, (Kinds{6, 1, 0, 0, 0, 0, 0, 0, 0, 2}));
                EXPECT_EQ(made.solid.facets_kept, 0U);
                const double bend = std::atan(down / (0.5 * kPi * reach));
                const double lune = 4.0 * (1.0 / std::cos(0.5 * bend) - 1.0);
                EXPECT_NEAR(made.solid.mitred_mm, lune, 0.05 * lune);
            }
        }
    }
}

// A ball goes down a line into a turn of a helix at the side of the stock. The envelope of the turn
// meets the groove of the line far from the corner of the path as well.
TEST(Recognise, KnowsHelicesOfBallsThatCrossTheWayThere) {
    for (const double rise : {-0.5, -0.8}) {
        SCOPED_TRACE(rise);
        const Golden golden{"turn",
                            fmt::format("T3 M6\nG0 X70 Y57 Z5\nG1 Z-1.3\nG1 X84 Z-7\n"
                                        "G3 X84 Y57 Z{} I-1.4 J0\nG0 Z5\n",
                                        -7.0 + rise),
                            {},
                            0.0};
        for (const double tolerance : {0.05, 0.02})
            EXPECT_EQ(make(golden, tolerance).solid.facets_kept, 0U) << tolerance;
    }
}

// A ball goes down a whole turn of a helix around a core, and then along a line, deeper than the
// ball is high. At the core, the side of the tool at rest touches the core's in a line, where the
// circle of the core's top begins. The edge of helix and line ends in points where both are
// tangent.
TEST(Recognise, KnowsTurnsOfHelicesAroundCores) {
    for (const double reach : {5.0, 8.0}) {
        for (const double down : {0.5, 2.0}) {
            for (const char* line : {"", "G1 Y40\n"}) {
                SCOPED_TRACE(testing::Message() << reach << ", " << down << ", " << line);
                const Golden golden{"turn",
                                    fmt::format("T3 M6\nG0 X45 Y30 Z5\nG1 Z-7\n"
                                                "G3 X45 Y30 Z{} I{} J0\n{}G0 Z5\n",
                                                -7.0 - down, -reach, line),
                                    {},
                                    0.0};
                EXPECT_EQ(make(golden, 0.05).solid.facets_kept, 0U);
            }
        }
    }
}

// A ball leaves a full circle along its tangent. Both grooves are tangent in a circle of the ball,
// and the ridge between them begins in the lowest point of this circle. In the second case the path
// comes from the line, so that the ball stood next to the ridge, too.
TEST(Recognise, KnowsBallsThatLeaveCirclesAlongTangents) {
    for (const double reach : {5.0, 10.0}) {
        for (const char* start : {"", "G1 Y35\nG1 Y40\n"}) {
            SCOPED_TRACE(testing::Message() << reach << ", " << start);
            const Golden golden{"tangent",
                                fmt::format("T3 M6\nG0 X60 Y40 Z5\nG1 Z-2\n{}"
                                            "G3 X60 Y40 I{} J0\nG1 Y50\nG0 Z5\n",
                                            start, -reach),
                                {},
                                0.0};
            for (const double tolerance : {0.05, 0.02})
                EXPECT_EQ(make(golden, tolerance).solid.facets_kept, 0U) << tolerance;
        }
    }
}

// A ball enters and leaves a closed contour along arcs that touch it: a circle, and a rectangle
// with rounded corners. The outer sides of contour and arcs touch in a line of no width.
TEST(Recognise, KnowsBallsThatEnterContoursOnArcs) {
    const Golden circle{"circle",
                        "T3 M6\nG0 X40 Y25 Z5\nG1 Z-2\nG3 X45 Y30 I0 J5\nG3 X45 Y30 I-15 J0\n"
                        "G3 X40 Y35 I-5 J0\nG0 Z5\n",
                        {},
                        0.0};
    const Golden rectangle{"rectangle",
                           "T3 M6\nG0 X35 Y15 Z5\nG1 Z-2\nG3 X40 Y10 I5 J0\nG1 X65\n"
                           "G3 X70 Y15 I0 J5\nG1 Y45\nG3 X65 Y50 I-5 J0\nG1 X15\n"
                           "G3 X10 Y45 I0 J-5\nG1 Y15\nG3 X15 Y10 I5 J0\nG1 X40\n"
                           "G3 X45 Y15 I0 J5\nG0 Z5\n",
                           {},
                           0.0};
    for (const double tolerance : {0.05, 0.02}) {
        EXPECT_EQ(kinds_of(make(circle, tolerance).solid.part), (Kinds{7, 0, 0, 2, 2}));
        EXPECT_EQ(kinds_of(make(rectangle, tolerance).solid.part), (Kinds{7, 5, 0, 2, 5}));
    }
}

// The same circle at any angle, with the three decimals of programs: contour and arcs are tangent
// within rounding only.
TEST(Recognise, KnowsBallsThatEnterRoundedContoursOnArcs) {
    for (const double degrees : {7.0, 45.0, 123.0}) {
        SCOPED_TRACE(degrees);
        const auto angle = sin_cos(degrees);
        const auto arc = [&](double x, double y, double i, double j) {
            return fmt::format("X{:.3f} Y{:.3f} I{:.3f} J{:.3f}\n",
                               40 + x * angle.cos - y * angle.sin,
                               30 + x * angle.sin + y * angle.cos, i * angle.cos - j * angle.sin,
                               i * angle.sin + j * angle.cos);
        };
        const auto start = arc(5, -5, 0, 0);
        const Golden golden{"circle",
                            "T3 M6\nG0 " + start.substr(0, start.find(" I")) + " Z5\nG1 Z-2\nG3 " +
                                arc(10, 0, 0, 5) + arc(10, 0, -10, 0) + arc(5, 5, -5, 0) +
                                "G0 Z5\n",
                            {},
                            0.0};
        EXPECT_EQ(kinds_of(make(golden, 0.05).solid.part), (Kinds{7, 0, 0, 2, 2}));
    }
}

// In drafts, arcs have few chords, and no facet shows a flat lune. Its depth is reported all the
// same; a deep lune stays.
TEST(Recognise, ReportsLunesWithoutFacets) {
    const auto draft_of = [](const std::string& moves) {
        const std::string program =
            "(T3 D=8. CR=4. - ball end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n"
            "G21 G90 G17 F300 S5000 M3\n" +
            moves + "M30\n";
        return test::make_part(setup::job_of({"lead-in.nc", program}), 0.05, 0, true).solid;
    };
    const Recognised flat = draft_of(lead_in_and_out(8.0, 0.5, 3.0));
    const double bend = std::atan(0.5 / (4.0 * kPi));
    EXPECT_EQ(kinds_of(flat.part), (Kinds{6, 1, 0, 2, 0, 0, 0, 0, 0, 2}));
    EXPECT_NEAR(flat.mitred_mm, 4.0 * (1.0 / std::cos(0.5 * bend) - 1.0), 1e-5);
    EXPECT_LE(draft_of(lead_in_and_out(3.0, 2.5, 1.0)).mitred_mm, 0.05);
}

// On a nearly level slope, the torus that remains around the flat end at a stop is 0.01 mm high. No
// facet indicates that torus.
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

// Strips of a torus that cannot stay are not inserted again and again.
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

// Bull noses move down, up and in a chain, and leave faces of their sides, too. The flat end
// nowhere moves level.
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

// The rim of a flat end leaves an envelope. At both ends of the path the rim's circle is an edge.
TEST(Recognise, KnowsTheRimsOfFlatEndsThatTurn) {
    const Golden golden{"rim",
                        "T1 M6\nG0 X20 Y30 Z20\nG1 Z-5\nG1 X55 Y33 Z-6 B3\nG0 Z60\n",
                        {7, 2, 0, 0, 0, 0, 0, 0, 0, 3},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.0055}, golden, left);
}

// An arc whose radius decreases towards its end, and a helix in a vertical plane.
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

// A corner radius moves on an arc hardly larger than itself. Its envelope folds, and edges of the
// face follow the fold, where some of their points have no place on the envelope. The projected
// area of a face follows from its edges for any direction. So the volume does not depend on the
// origin of the sum.
// Readers take edges within 1e-7 mm of a surface for exact, so patches must be nearer than that.
TEST(Envelope, PatchesAreNearerThanReadersMeasure) {
    const Made made = make({"slope", "T4 M6\nG0 X-10 Y30 Z0\nG1 X90 Z-6\nG0 Z5\n", {}, 0.0}, 0.02);
    std::size_t patches = 0;
    for (const Face& face : made.solid.part.faces) {
        if (!std::holds_alternative<Envelope>(face.surface.form)) continue;
        ++patches;
        const Patch patch = patch_of(made.solid.part, face);
        double most = 0.0;
        for (std::size_t i = 0; i + 1 < patch.around.size(); ++i) {
            for (std::size_t j = 0; j + 1 < patch.along.size(); ++j) {
                const double u = 0.3 * patch.around[i] + 0.7 * patch.around[i + 1];
                const double v = 0.6 * patch.along[j] + 0.4 * patch.along[j + 1];
                most =
                    std::max(most, std::abs(distance(face.surface.form, point_of(patch, u, v).at)));
            }
        }
        EXPECT_LT(most, 5e-8);
    }
    EXPECT_EQ(patches, 1U);
}

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
                                              cross(from - part.vertices[0], to - from);
                }
            }
        }
        const double here = three(face, {});
        const Vec3 area{here - three(face, {1, 0, 0}), here - three(face, {0, 1, 0}),
                        here - three(face, {0, 0, 1})};
        EXPECT_LT(norm(area - of_edges), 2e-3);
    }
    EXPECT_EQ(envelopes, 6);
}

// An arc of 300 turns yields few candidate surfaces. With two candidates per turn for each facet, a
// line of 40 characters takes a minute.
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
        if (!std::holds_alternative<gcode::Arc>(motion.action)) return;
        ++arcs;
        const SweptSurfaces source =
            surfaces_of(motion, survey.tools.at(motion.tool).tool, nullptr);
        const auto envelopes =
            std::ranges::count_if(source.candidates, [](const CandidateSurface& c) {
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
