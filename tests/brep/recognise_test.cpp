// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognised parts: corners, walls, domes, slits and splines that once failed, and parts of random
// programs.
#include "ncsim/brep/measure.h"
#include "ncsim/cda/boundary.h"

#include "brep/cam_parts.h"
#include "brep/golden.h"
#include "brep/groove_parts.h"
#include "brep/made_part.h"
#include "brep/random_parts.h"
#include "brep/slot_parts.h"
#include "query/part_check.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
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

// A full turn, 4 mm deep over 30π mm. Edges of the walls and the floor along the helix are splines.
// Each point of the floor is as deep as the last pass of the disc of radius 5 mm, at the disc's
// rear.
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

// Three quarters of a turn, 3 mm deep, by a tool wider than its path. At the end the tool stands in
// front of a wall whose corners are on the floor that descended next to the wall, though the wall's
// middle is not. Treating the wall as floor would leave a cave of 0.9 mm³.
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

// A half turn that ends 0.05 mm nearer to its centre. The strip that the disc covers has the same
// width along the whole path.
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

// Nearly a full turn, by a tool that is small compared with the gap that remains. If the path
// counted as returning near its start, the whole part would stay facets.
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

// Returns the volume (mm³) that the ball of 8 mm removes, 6 mm deep, by squares of 0.02 mm.
// `distance` returns the distance (mm) of a square's middle from the path.
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

// The path ends in a spherical cap. The pipe of a longer, earlier line passes through the cap's
// middle by chance. The cap must not join the pipe as if the path only bent there.
TEST(Recognise, KeepsTheBallAtTheEndOfAWay) {
    const Golden golden{
        "hook", "T3 M6\nG0 X35 Y30 Z5\nG1 Z-6\nG1 X45\nG2 X51 Y30 I3 J3\nG0 Z5\n", {}, 0.0};
    const double radius = std::sqrt(18.0);
    const auto distance = [&](double x, double y) {
        const double u = x - 48.0, v = y - 33.0;
        const bool is_below = v < -std::abs(u);  // outside the arc's sector
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

// A ball crosses its own path at one depth, as in engravings. Both grooves are tangent in the
// lowest point of each crossing, where the curves in which they meet cross. A line leaves two faces
// of the ring and three of its own groove; two full circles leave two or three faces each.
TEST(Recognise, KnowsGroovesThatCrossAtOneDepth) {
    const auto ring = [](double x, double y, double centre) {
        return std::abs(std::hypot(x - centre, y - 30.0) - 12.0);
    };
    struct Case {
        std::string moves;
        std::function<double(double, double)> distance;
        int cylinders, tori;
    };
    const std::vector<Case> cases{
        {"G0 X-9 Y35 Z5\nG1 Z-6\nG1 X89\nG0 Z5\nG0 X52 Y30\nG1 Z-6\nG3 X52 Y30 I-12 J0\nG0 Z5\n",
         [&](double x, double y) { return std::min(std::abs(y - 35.0), ring(x, y, 40.0)); }, 6, 2},
        {"G0 X45 Y30 Z5\nG1 Z-6\nG3 X45 Y30 I-12 J0\nG0 Z5\nG0 X59 Y30\nG1 Z-6\n"
         "G2 X59 Y30 I-12 J0\nG0 Z5\n",
         [&](double x, double y) { return std::min(ring(x, y, 33.0), ring(x, y, 47.0)); }, 8, 4},
    };
    for (const Case& c : cases) {
        const double left = kBlock - removed_by_ball(c.distance);
        for (const double tolerance : {0.05, 0.02}) {
            SCOPED_TRACE(c.moves + std::to_string(tolerance));
            const Made made = make({"crossing", "T3 M6\n" + c.moves, {}, 0.0}, tolerance);
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_NEAR(volume(made.solid.part), left, 0.1);
            const Kinds kinds = kinds_of(made.solid.part);
            EXPECT_EQ(kinds[1], c.cylinders);
            EXPECT_EQ(kinds[4], c.tori);
        }
    }
}

// On a circle narrower than itself, a ball leaves a torus with a tip in the middle. The tip is
// inside the face of a full circle, and a corner between three faces on a part of a circle.
TEST(Recognise, KnowsCirclesNarrowerThanTheBall) {
    for (const double degrees : {135.0, 225.0, 315.0, 360.0}) {
        const double end = degrees * kPi / 180.0;
        const double x = 40.0 + 2.0 * std::cos(end), y = 30.0 + 2.0 * std::sin(end);
        const auto distance = [&](double u, double v) {
            const double turn = std::atan2(v - 30.0, u - 40.0);
            if ((turn < 0.0 ? turn + 2.0 * kPi : turn) <= end)
                return std::abs(std::hypot(u - 40.0, v - 30.0) - 2.0);
            return std::min(std::hypot(u - 42.0, v - 30.0), std::hypot(u - x, v - y));
        };
        const double left = kBlock - removed_by_ball(distance);
        const std::string moves =
            fmt::format("T3 M6\nG0 X42 Y30 Z5\nG1 Z-6\nG3 X{:.9f} Y{:.9f} I-2 J0\nG0 Z5\n", x, y);
        const bool is_full = degrees == 360.0;
        for (const double tolerance : {0.05, 0.02}) {
            SCOPED_TRACE(moves + std::to_string(tolerance));
            const Made made = make({"circle", moves, {}, 0.0}, tolerance);
            EXPECT_EQ(kinds_of(made.solid.part),
                      (Kinds{6, is_full ? 1 : 3, 0, is_full ? 0 : 2, 1}));
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_NEAR(volume(made.solid.part), left, 0.1);
        }
    }
}

// A bore from the side of a bar has a closed spline as its mouth, with steps of equal length.
// OpenCASCADE searches curves on the bar at even steps of their parameter. If the first steps are
// half a micrometre, OpenCASCADE finds that the curve crosses itself.
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
            steps.push_back(norm(track.at(spline->knots[i + 1] / spline->knots.back()) -
                                 track.at(spline->knots[i] / spline->knots.back())));
        const auto [shortest, longest] = std::ranges::minmax(steps);
        EXPECT_GT(shortest, 0.1 * longest);
    }
    EXPECT_EQ(closed, 1);
}

// Two V-grooves of the same depth end 16 µm apart, so their cones meet in a hyperbola as sharp as a
// needle. Points far from the hyperbola's end lie behind that end; the curve must still be followed
// in the right direction.
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

// Two arcs are tangent up to the rounding of their numbers. The exact circles of their walls miss
// the common vertex by almost a micrometre and cross next to the vertex.
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
            EXPECT_NEAR(norm(out), circle->radius, 2e-7);
        }
    }
}

// An engraver's path returns along itself up to rounding. Between both walls on a side is a strip
// that faces the opposite side. The strip is as flat as it is narrow, and has no width where the
// walls meet.
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

// A slot is deepened from its end on, where the path bends by less than the width of a facet. The
// wall of the bend touches the walls of both slots; the upper slot's wall ends there. So the slit
// between the walls is shorter on a side.
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
        EXPECT_TRUE(check_part(checked, 1e-6).empty());
    }
}

// True if a facet is adjacent to a face of type `Form`.
template <typename Form>
bool has_facet_beside(const Part& part) {
    std::vector<std::vector<std::uint32_t>> adjacent_faces(part.edges.size());
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const Loop& loop : part.faces[f].loops) {
            for (const EdgeUse& use : loop)
                adjacent_faces[use.edge].push_back(f);
        }
    }
    return std::ranges::any_of(adjacent_faces, [&](const auto& faces) {
        bool has_facet = false, has_form = false;
        for (const std::uint32_t f : faces) {
            has_facet = has_facet || part.faces[f].is_facet;
            has_form = has_form || std::holds_alternative<Form>(part.faces[f].surface.form);
        }
        return has_facet && has_form;
    });
}

// A ball on a helix smaller than the ball leaves facets in the floor of a ramp. The ramp is less
// steep than the facets are large. Readers would find edges of adjacent facets on the opposite side
// of the ramp and draw nothing.
TEST(Recognise, FlatRampsHaveNoFacetsBesideThem) {
    const Golden golden{"flat_ramp",
                        "T1 M6\nG0 X15 Y30 Z5\nG1 Z-3\nG1 X65 Z-3.1\nG0 Z5\n"
                        "T3 M6\nG0 X40 Y30 Z5\nG1 Z-3\nG2 X40 Y30 Z-5 I-1.5 J0\nG0 Z5\n",
                        {},
                        0.0};
    const Made made = make(golden, 0.05);
    EXPECT_GT(made.solid.facets_kept, 0U);
    EXPECT_FALSE(has_facet_beside<Extrusion>(made.solid.part));
}

// Two vertical arcs end in the same point. Corners of facets adjacent to a dome may lie beyond the
// half of the dome that is a face; readers then draw nothing.
TEST(Recognise, DomesHaveNoFacetsBesideThem) {
    const Golden golden{"dips_to_a_point",
                        "T1 M6\nG0 X55 Y30 Z5\nG1 Z0\nG18 G3 X40 Z-15 I-15 K0\nG0 Z5\n"
                        "G0 X40 Y45\nG1 Z0\nG19 G2 Y30 Z-15 J-15 K0\nG0 Z5\nG17\n",
                        {},
                        0.0};
    EXPECT_FALSE(has_facet_beside<Dome>(make(golden, 0.05).solid.part));
}

// A move of 0.1 µm leaves two corners at a place of the wall's loop. Unless both merge, the wall
// stays a facet.
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
    EXPECT_TRUE(check_part(checked, 1e-3).empty());
}

// A failure must not spread. If thin faces demote their neighbours, and a plane that touches itself
// in a point demotes all adjacent faces, these parts have 510, 370 and 163 facets.
TEST(Recognise, WhatFailsInOnePlaceStaysThere) {
    for (const auto& [seed, most] : {std::pair(5117U, 60U), {5066U, 60U}, {5100U, 60U}}) {
        const Made made =
            test::make_part(setup::job_of({"part.nc", test::random_part(seed)}), 0.05);
        EXPECT_LE(made.solid.facets_kept, most) << seed;
    }
}

// Four defects leave 3 to 218 facets on these parts. An edge that continues from an ellipse to the
// next, where pipes of a ball bend, lacks a vertex. Corners in the wrong order in the polyhedron
// are searched far away. Edges of 0.1 µm are missing. Faces without width remove the adjacent
// walls.
TEST(Recognise, FinishingByABallLeavesNoFacets) {
    for (const std::uint64_t seed :
         {3U, 5U, 7U, 11U, 15U, 19U, 20U, 33U, 43U, 48U, 49U, 52U, 58U}) {
        const Made made = test::make_part(
            setup::job_of({"part.nc", test::random_part(test::kRasters + seed)}), 0.05);
        EXPECT_EQ(made.solid.facets_kept, 0U) << seed;
        EXPECT_EQ(made.solid.shells_kept, 0U) << seed;
    }
}

// A lollipop mill leaves a torus above the middle of its ball, too, where a spindle torus (minor
// radius > major radius) can have no face. Facets stay there, but all other faces are recognised.
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

// Neither polygons in place of round tools nor their number may decide which face a facet belongs
// to. A low wall once became part of the torus below it, at one tolerance and not at another.
TEST(Recognise, VolumesDoNotDependOnTheTolerance) {
    constexpr std::uint64_t kPartsOfAKind = 8;
    constexpr double kExact = 1e-6;  // mm
    std::vector<std::pair<std::uint64_t, std::string>> programs;
    for (std::uint64_t i = 0; i < kPartsOfAKind; ++i) {
        programs.emplace_back(test::kGrooves + i, test::groove_part(test::kGrooves + i));
        programs.emplace_back(test::kCam + i, test::cam_part(test::kCam + i));
        programs.emplace_back(test::kSlots + i, test::slot_part(test::kSlots + i));
    }
    std::size_t compared = 0;
    for (const auto& [seed, program] : programs) {
        const auto recognised = [&](double tolerance) {
            return test::make_part(setup::job_of({"part.nc", program}), tolerance).solid;
        };
        const auto is_exact = [](const Recognised& solid) {
            return solid.facets_kept == 0 && solid.mitred_mm == 0.0 && solid.part.miss_mm < kExact;
        };
        const Recognised coarse = recognised(0.05);
        if (!is_exact(coarse)) continue;
        const Recognised fine = recognised(0.02);
        // Polygons do not show faces that are less deep than they are inexact.
        if (!is_exact(fine) || coarse.part.faces.size() != fine.part.faces.size()) continue;
        ++compared;
        const double all = volume(fine.part);
        EXPECT_NEAR(volume(coarse.part), all, 1e-7 * all) << seed;
    }
    EXPECT_GT(compared, kPartsOfAKind);
}

// Most of these parts keep facets if consecutive moves that continue each other are treated
// separately.
TEST(Recognise, CamProgramsLeaveNoFacets) {
    for (const std::uint64_t seed : {0U,  1U,  2U,  3U,  4U,  6U,  8U,  11U, 12U, 13U, 14U,
                                     15U, 17U, 19U, 21U, 22U, 23U, 26U, 30U, 32U, 67U, 85U}) {
        const Made made =
            test::make_part(setup::job_of({"part.nc", test::cam_part(test::kCam + seed)}), 0.05);
        EXPECT_EQ(made.solid.facets_kept, 0U) << seed;
    }
}

// A deeper pocket touches the outline of a floor from inside, along an arc of both. Readers draw
// nothing of that floor, so it is split into two faces along a line.
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
    EXPECT_TRUE(check_part(part, 1e-3).empty());
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

// Neither the floor's outline nor its hole has a vertex except the point of contact. So a round
// edge of each is split.
TEST(Recognise, PlanesArePartedWhereRoundEdgesTouch) {
    Made made = test::make_part(
        "ring", "T1 M6\nG0 X30 Y30 Z5\nG1 Z-4\nG3 X30 Y30 I10 J0\nG1 Z-8\nG1 X38\nG0 Z5\n");
    EXPECT_EQ(made.solid.facets_kept, 0U);
    EXPECT_TRUE(check_part(made.solid.part, 1e-6).empty());
    const auto is_floor = [](const Face& face) {
        const auto* plane = std::get_if<Plane>(&face.surface.form);
        return plane && plane->normal.z > 0.5 && std::abs(plane->origin.z + 4.0) < 1e-6;
    };
    EXPECT_EQ(std::ranges::count_if(made.solid.part.faces, is_floor), 2);
    for (const Face& face : made.solid.part.faces)
        EXPECT_TRUE(!is_floor(face) || face.loops.size() == 1);
}

// A finer cut does not help if a flat end that rotates moves level, there or in adjacent faces.
// None is requested.
TEST(Recognise, FacetsBesideThoseOfATurningToolAreNotGivenUp) {
    const test::Made turning = test::make_part(
        "turning", "T1 M6\nG0 X-10 Y30 Z20\nG1 Z-4\nG1 X20\nG1 X60.48 Y33 Z4.54 B10\nG0 Z60\n");
    EXPECT_GT(turning.solid.facets_kept, 20U);
    EXPECT_EQ(turning.solid.facets_demoted, 0U);
}

// A slot along a cubic spline has walls of cylinders because arcs replace the spline within 2 µm.
// The slot is as wide as the tool along its whole length and has a round end.
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

// A spline of degree 1 has a corner, where the tool leaves a round wall.
TEST(Recognise, KnowsCornersOfSplines) {
    const Golden golden{"corner",
                        "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG5.2 P1 L2\nX40 Y20 P1\nX40 Y40 P1\nG5.3\n"
                        "G0 Z5\n",
                        {11, 3},
                        0.0};
    // Two rectangles with a common corner, two half discs and a quarter disc.
    const double left = kBlock - 4.0 * (2.0 * 20.0 * 10.0 - 5.0 * 5.0 + 1.25 * kPi * 25.0);
    expect_at({0.05, 0.02, 0.0055}, golden, left, 1e-9);
}

}  // namespace
}  // namespace ncsim::brep
