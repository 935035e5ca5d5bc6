// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts with faces that rounding separates, and with details narrower than the sides of a polygon:
// oblique walls, strips, tips.
#include "ncsim/brep/measure.h"

#include "brep/golden.h"
#include "brep/made_part.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <variant>

namespace ncsim::brep {
namespace {

using test::expect_at;
using test::Golden;
using test::Kinds;
using test::kinds_of;
using test::kPi;
using test::Made;
using test::make;

// An oblique pocket by two tools, the second at two depths. Each wall is a plane up to a micrometre
// of rounding, by which its pieces cross anywhere. Facets of the tools deviate by far more.
TEST(Recognise, KnowsWallsThatProgramsRoundApart) {
    const std::string finish =
        "X-4.971 Y4.954\nX-4.3 Y-5.547\nX4.971 Y-4.954\nX4.3 Y5.547\nG0 Z5\n";
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = test::make_part(
            setup::job_of(
                {"askew.nc",
                 "(T1 D=3.175 CR=0. - flat end mill)\n(T2 D=1.5875 CR=0. - flat end mill)\n"
                 "(STOCK/BLOCK,40.,40.,8.,20.,20.,8.)\nG21 G90 G17 F300 S5000 M3\nT1 M6\n"
                 "G0 X3.558 Y4.704 Z5\nG1 Z-2\nX-4.129 Y4.212\nX-3.558 Y-4.704\n"
                 "X4.129 Y-4.212\nX3.558 Y4.704\nG0 Z5\nT2 M6\nG0 X4.3 Y5.547 Z5\n"
                 "G1 Z-2\n" +
                     finish + "G0 X4.3 Y5.547 Z5\nG1 Z-4\n" + finish + "M30\n"}),
            tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{21, 4}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
        // An island stays. It is wider below, where the larger tool did not cut.
        constexpr double kOutline = 10.8774 * 12.1096 - (4.0 - kPi) * 0.79375 * 0.79375;
        constexpr double kTaken =
            2.0 * (kOutline - 4.5277 * 5.7593) + 2.0 * (kOutline - 7.7025 * 8.9349);
        EXPECT_NEAR(volume(made.solid.part), 40.0 * 40.0 * 8.0 - kTaken, 0.1);
    }
}

// A move of 0.1 mm at the end of a groove. Between both ends of the move, a V-cutter leaves a strip
// of a plane on the whole wall. Facets indicate only a quarter of the strip's height.
TEST(Recognise, KnowsStripsBesideShortMoves) {
    const Golden golden{"short",
                        "T5 M6\nG0 X25.5675 Y22.5298 Z5\nG1 Z-1.27\nG1 X29.7128 Y22.4815\nG0 Z5\n"
                        "G0 X26.4946 Y23.2156\nG1 Z-1.27\nG1 X25.5675 Y22.6314\n"
                        "G1 X25.5675 Y22.5298\nG0 Z5\n",
                        {12, 0, 4},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.0055}, golden, left);
}

// The round end of a second path breaks through a wall by 2.5 µm, 0.13 mm wide. Treating both as
// tangent would make two edges cross.
TEST(Recognise, KnowsWhereWallsCrossByLittle) {
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = test::make_part(
            setup::job_of(
                {"fin.nc",
                 "(T1 D=1.5875 CR=0. - flat end mill)\n"
                 "(STOCK/BLOCK,20.,20.,6.,-70.,-75.,6.)\nG21 G90 G17 F300 S5000 M3\nT1 M6\n"
                 "G0 X79.8368 Y78.2213 Z5\nG1 Z-1.5\nG1 X78.2381 Y82.8363\n"
                 "G1 X81.9037 Y86.5571\nG0 Z5\nG0 X83.4264 Y86.2949\nG1 Z-1.5\n"
                 "G1 X79.9468 Y82.3124\nG1 X81.5178 Y77.959\nG0 Z5\nM30\n"}),
            tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{16, 6}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
    }
}

// A V-groove around corners of radius 3.5 mm, 3.4 mm deep. Inside, the hill of each corner is 0.1
// mm wide at the top; polygons in place of the cutter leave half a millimetre.
TEST(Recognise, KnowsHillsWithinTheArcsOfVCutters) {
    const Golden golden{"hill",
                        "T5 M6\nG0 X40 Y20 Z5\nG1 Z-3.4\nG1 X49.5\nG3 X53 Y23.5 I0 J3.5\nG1 Y36.5\n"
                        "G3 X49.5 Y40 I-3.5 J0\nG1 X30.5\nG3 X27 Y36.5 I0 J-3.5\nG1 Y23.5\n"
                        "G3 X30.5 Y20 I3.5 J0\nG1 X40\nG0 Z5\n",
                        {15, 0, 8},
                        0.0};
    constexpr double kTaken = 3.4 * 3.4 * (64.0 + 2.0 * kPi * 3.5);
    expect_at({0.05, 0.02, 0.0055, 0.002}, golden, 80.0 * 60.0 * 20.0 - kTaken, 1e-9);
}

// The same groove, oblique and in inches with four decimals, a grid of 2.5 µm. Where lines and arcs
// meet, edges as short as that remain.
TEST(Recognise, KnowsVGroovesAskewInInches) {
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        SCOPED_TRACE(tolerance);
        const Made made = test::make_part(
            setup::job_of({"inches.nc",
                           "(T1 D=10. CR=0. TAPER=45deg - chamfer mill)\n"
                           "(STOCK/BLOCK,2.3622,2.3622,0.4724,1.1811,1.1811,0.4724)\n"
                           "G90 G17 F300 S5000 M3\nG20\nT1 M6\nG0 X0.4654 Y0.3422 Z0.2\n"
                           "G1 Z-0.1339\nX0.1697 Y0.7444\nG3 X0.0596 Y0.7612 I-0.0634 J-0.0466\n"
                           "G1 X-0.7444 Y0.17\nG3 X-0.7612 Y0.06 I0.0466 J-0.0634\n"
                           "G1 X-0.1697 Y-0.7444\nG3 X-0.0596 Y-0.7612 I0.0634 J0.0466\n"
                           "G1 X0.7444 Y-0.17\nG3 X0.7612 Y-0.06 I-0.0466 J0.0634\n"
                           "G1 X0.4654 Y0.3422\nG0 Z0.2\nM30\n"}),
            tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{17, 0, 8}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
    }
}

// Cones of the arc by which a V-cutter enters pass 1.5 µm from the tip at the arc's start.
// OpenCASCADE takes a vertex that near an apex for the apex, and draws nothing of its face.
TEST(Recognise, HasCornersInTipsNotBesideThem) {
    const Made made = test::make_part(
        setup::job_of({"tips.nc",
                       "(T1 D=10. CR=0. TAPER=45deg - chamfer mill)\n"
                       "(STOCK/BLOCK,2.3622,2.3622,0.4724,1.1811,1.1811,0.4724)\n"
                       "G90 G17 F300 S5000 M3\nG20\nT1 M6\nG0 X0.4557 Y0.27 Z0.2\nG1 Z-0.0669\n"
                       "G3 X0.4673 Y0.3527 I-0.0356 J0.0471\nG1 X0.1034 Y0.8347\n"
                       "G3 X-0.0069 Y0.8501 I-0.0628 J-0.0474\nG1 X-0.8157 Y0.2395\n"
                       "G3 X-0.8311 Y0.1292 I0.0474 J-0.0628\nG1 X-0.1034 Y-0.8347\n"
                       "G3 X0.0069 Y-0.8501 I0.0628 J0.0474\nG1 X0.8157 Y-0.2395\n"
                       "G3 X0.8311 Y-0.1292 I-0.0474 J0.0628\nG1 X0.4673 Y0.3527\n"
                       "G3 X0.3846 Y0.3643 I-0.0471 J-0.0356\nG0 Z0.2\nM30\n"}),
        0.05);
    const Part& part = made.solid.part;
    EXPECT_EQ(made.solid.facets_kept, 0U);
    int in_tips = 0;
    for (const Face& face : part.faces) {
        const auto* cone = std::get_if<Cone>(&face.surface.form);
        if (!cone) continue;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const double deviation =
                    norm(part.vertices[part.edges[use.edge].from] - cone->apex);
                if (deviation == 0.0) ++in_tips;
                EXPECT_TRUE(deviation == 0.0 || deviation > 3e-3) << deviation;
            }
        }
    }
    EXPECT_GT(in_tips, 0);
}

// An arc in alternate lines of 8 µm and 1 µm. Two of its walls are part of each other up to
// rounding; joining must not alternate between both.
TEST(Recognise, WallsAreNotJoinedToAndFro) {
    const Made made = test::make_part(
        setup::job_of({"isolation.nc",
                       "(T1 D=0.2 CR=0. - flat end mill)\n(STOCK/BLOCK,3.,3.,1.,0.5,-10.5,1.)\n"
                       "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X0.69922 Y12.00826\nG1 Z-0.05\n"
                       "X0.69170 Y12.00557\nX0.69076 Y12.00521\nX0.68327 Y12.00245\n"
                       "X0.68233 Y12.00209\nX0.67483 Y11.99922\nX0.67392 Y11.99886\n"
                       "X0.66645 Y11.99594\nX0.66554 Y11.99556\nX0.65812 Y11.99254\n"
                       "X0.65718 Y11.99218\nX0.64982 Y11.98909\nX0.64888 Y11.98870\n"
                       "X0.64154 Y11.98555\nG0 Z5\nM30\n"}),
        0.05);
    EXPECT_EQ(kinds_of(made.solid.part)[1], 2);
    EXPECT_EQ(made.solid.facets_kept, 0U);
}

// Arcs of the outline of a letter, by a tool hardly narrower than an arc. Where the arcs meet, two
// facets of the same wall are 2 µm wide and have arbitrary normals.
TEST(Recognise, KnowsFacetsThatLookAnywhere) {
    const Made made = test::make_part(
        setup::job_of({"letter.nc",
                       "(T1 D=0.2 CR=0. - flat end mill)\n(STOCK/BLOCK,8.,8.,3.,-53.,-138.,3.)\n"
                       "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X55.627333 Y139.257619\nG1 Z-1\n"
                       "G3 X55.689239 Y140.010650 I-360.500100 J30.015265\n"
                       "G2 X56.129706 Y142.210600 I9.608984 J-0.779809\n"
                       "G2 X57.361522 Y145.156280 I18.570839 J-6.035504\n"
                       "G2 X57.560947 Y145.112084 I0.093838 J-0.048606\n"
                       "G2 X57.407392 Y144.057910 I-2.871840 J-0.119947\n"
                       "G3 X57.145820 Y143.074205 I6.772678 J-2.327515\n"
                       "G3 X57.095703 Y142.426370 I2.866516 J-0.547614\nG0 Z5\nM30\n"}),
        0.05);
    EXPECT_EQ(kinds_of(made.solid.part), (Kinds{7, 16}));
    EXPECT_EQ(made.solid.facets_kept, 0U);
}

// An arc starts 0.1 µm off its wall, because the preceding arc ought to be tangent there, and ends
// in a corner. With the radius of its start, the arc crosses an adjacent edge in that corner
// (OpenCASCADE: not valid).
TEST(Recognise, CirclesAreAsWideAsTheirWalls) {
    const Made made = test::make_part(
        setup::job_of({"corner.nc",
                       "(T1 D=0.2 CR=0. - flat end mill)\n(STOCK/BLOCK,12.,12.,3.,-70.,-10.,3.)\n"
                       "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X78.461745 Y27.235018\nG1 Z-1\n"
                       "G2 X78.481151 Y26.404061 I-30.373898 J-1.125046\n"
                       "G2 X78.507900 Y22.465016 I-682.629744 J-6.605184\n"
                       "G2 X78.520816 Y18.552545 I-3100.246320 J-12.191476\n"
                       "G2 X78.523285 Y16.703497 I-692.449336 J-1.849007\n"
                       "G2 X79.247643 Y19.781282 I290.211243 J-66.677235\n"
                       "G2 X79.847015 Y22.197044 I179.387306 J-43.225326\nG0 Z5\nM30\n"}),
        0.05);
    const Part& part = made.solid.part;
    EXPECT_EQ(made.solid.facets_kept, 0U);
    int circles = 0;
    for (const Face& face : part.faces) {
        const auto* wall = std::get_if<Cylinder>(&face.surface.form);
        if (!wall) continue;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const auto* circle = std::get_if<Circle>(&part.edges[use.edge].curve);
                if (!circle) continue;
                ++circles;
                EXPECT_NEAR(circle->radius, wall->radius, 1e-11 * wall->radius);
            }
        }
    }
    EXPECT_GT(circles, 8);
}

Made groove(const std::string& moves, double tolerance) {
    return test::make_part(setup::job_of({"arc.nc",
                                          "(T1 D=3. CR=0. - flat end mill)\n"
                                          "(STOCK/BLOCK,60.,60.,12.,30.,30.,12.)\n"
                                          "G21 G90 G17 F300 S5000 M3\nT1 M6\n" +
                                              moves + "G0 Z5\nM30\n"}),
                           tolerance);
}

Made arc_between_plunges(const std::string& arc, double tolerance) {
    return groove("G0 X20 Y0 Z5\nG1 Z-3\nG0 Z-2\n" + arc + "\nG1 Z-3\n", tolerance);
}

// Ends and centre are rounded to a micrometre, so the radii of both ends differ by as much. The
// walls are about the circle through both ends, and tangent to the plunges there.
TEST(Recognise, ArcsEndWhereTheToolPlunges) {
    for (const std::string arc : {"G3 X14.143 Y14.142 I-20 J0", "G2 X-0.001 Y-20.002 I-20 J0",
                                  "G3 X5.176 Y19.319 I-20 J0", "G2 X0.667 Y19.988 I-20 J0"}) {
        for (const double tolerance : {0.05, 0.02, 0.0055}) {
            SCOPED_TRACE(arc + " within " + std::to_string(tolerance));
            const Made made = arc_between_plunges(arc, tolerance);
            // Block with a top and two floors of holes; floor of the slot; its two walls and the
            // walls of both holes, each in one piece.
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_EQ(kinds_of(made.solid.part), (Kinds{9, 4}));
            EXPECT_LE(made.solid.part.miss_mm, 1e-9);
        }
    }
}

// Pieces of a circle about one centre, each with ends rounded to a micrometre, are one wall.
TEST(Recognise, PiecesOfACircleAreOneWall) {
    for (const int pieces : {2, 3, 4, 6, 24, 36}) {
        SCOPED_TRACE(pieces);
        const auto corner = [&](int i) {
            const double angle = 0.3 + 2.0 * kPi * (i % pieces) / pieces;
            return std::array{std::round(10620.0 * std::cos(angle)) * 1e-3,
                              std::round(10620.0 * std::sin(angle)) * 1e-3};
        };
        auto [x, y] = corner(0);
        std::string moves = "G0 X" + std::to_string(x) + " Y" + std::to_string(y) + " Z5\nG1 Z-2\n";
        for (int i = 1; i <= pieces; ++i) {
            const std::string centre = " I" + std::to_string(-x) + " J" + std::to_string(-y) + "\n";
            const auto to = corner(i);
            x = to[0];
            y = to[1];
            moves += "G3 X" + std::to_string(x) + " Y" + std::to_string(y) + centre;
        }
        const Made made = groove(moves, 0.02);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{8, 2}));
    }
}

// The same circle has its centre 7 mm away if the ends are 1.4 µm apart, one of them off by 1 µm.
TEST(Recognise, NearlyFullCirclesKeepTheirCentre) {
    for (const std::string arc : {"G3 X20.001 Y-0.001 I-20 J0", "G2 X19.998 Y0.02 I-20 J0"}) {
        SCOPED_TRACE(arc);
        const Made made = arc_between_plunges(arc, 0.02);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        int walls = 0;
        for (const Face& face : made.solid.part.faces) {
            const auto* wall = std::get_if<Cylinder>(&face.surface.form);
            if (!wall || wall->radius < 10.0) continue;
            ++walls;
            EXPECT_NEAR(wall->origin.x, 0.0, 3e-3);
            EXPECT_NEAR(wall->origin.y, 0.0, 3e-3);
            EXPECT_NEAR(std::abs(wall->radius - 20.0), 1.5, 2e-3);
        }
        EXPECT_EQ(walls, 2);
    }
}

}  // namespace
}  // namespace ncsim::brep
