// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ramps: a flat end that moves down or up leaves an extruded circle.
#include "ncsim/brep/frames.h"
#include "ncsim/brep/measure.h"
#include "ncsim/brep/parameter_curve.h"

#include "brep/golden.h"
#include "brep/made_part.h"
#include "query/part_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <variant>

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

// Two ramps meet obliquely on a ridge. The edge of their floors has a corner that is nearer to the
// edge's end than facets are wide. The four faces at a corner of the polyhedron have no common
// point. The stop of the tool between the walls leaves a strip of 0.62 mm, with the circle of the
// bend along it. Without that strip, which is as small as a facet, the floors share an edge twice.
TEST(Recognise, KnowsRampsThatMeetAskew) {
    const Golden golden{"ridge",
                        "T1 M6\nG0 X10 Y30 Z5\nG1 X20 Z-5\nG1 X30 Z-2\nG1 X70 Y25 Z-12\nG0 Z5\n",
                        {12, 2, 0, 0, 0, 3},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.01, 0.0055, 0.001}, golden, left, 1e-9);
}

// Down a ramp, along a slot and back, and up a second, oblique ramp. The second ramp's wall touches
// its floor from the start on, on the circle where both ramps begin. The floor of the first ramp
// crosses both there and a little higher; the corner of the three faces is the higher crossing.
TEST(Recognise, KnowsRampsThatMeetInAValley) {
    for (const std::string end : {"34", "38"}) {
        const Golden golden{
            "valley",
            "T1 M6\nG0 X10 Y30 Z5\nG1 X30 Z-8\nG1 Y10\nG1 Y30\nG1 X60 Y" + end + " Z-2\nG0 Z5\n",
            {13, 2, 0, 0, 0, 2},
            0.0};
        const double left = volume(make(golden, 0.002).solid.part);
        SCOPED_TRACE(end);
        expect_at({0.05, 0.02, 0.0055}, golden, left, 1e-9);
    }
}

// Down a helix into a groove around an island, once around, and out on a second helix. Both helices
// leave the island's wall in the point where the wall touches the circle of their floor. The wall
// is pinched, and a loop visits the point twice.
TEST(Recognise, KnowsHelicesThatTouchAWallInAPoint) {
    const Golden golden{"helices",
                        "T1 M6\nG0 X40 Y30 Z5\nG1 Z0\nG3 X60 Y30 Z-1 I10 J0\nG3 I-20\nG3 X40 Y30 "
                        "Z1 I-10 J0\nG0 Z5\n",
                        {8, 4, 0, 0, 0, 0, 0, 2},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.0055}, golden, left, 1e-7);
}

// Only the helix out of the groove, with the rounding of a rotated program. Groove and helix miss
// the point by 1 or 2 µm, so its corners are separate or have an edge in between.
TEST(Recognise, KnowsHelicesThatTouchAWallButForRounding) {
    for (const std::string way : {"G0 X60.000 Y32.679 Z10\nG1 Z-1\nG3 I-10.000 J17.321\n"
                                  "G3 X50.000 Y50.000 Z1 I-5.000 J8.660\n",
                                  "G0 X39.107 Y66.773 Z10\nG1 Z-1\nG3 I10.893 J-16.773\n"
                                  "G3 X50.000 Y50.000 Z1 I5.446 J-8.387\n"}) {
        const Made made = test::make_part(
            setup::job_of({"out.nc",
                           "(T3 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,100.,100.,10.,0.,"
                           "0.,10.)\nG21 G90 G17 F300 S5000 M3\nT3 M6\n" +
                               way + "G0 Z30\nM30\n"}),
            0.05);
        EXPECT_EQ(kinds_of(made.solid.part), (Kinds{8, 3, 0, 0, 0, 0, 0, 1}));
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_LT(made.solid.part.miss_mm, 3e-3);
    }
}

// Parallel ramps, a diameter apart. Their floors touch in a point and meet between the paths in an
// edge of zero angle.
TEST(Recognise, KnowsRampsThatTouch) {
    const std::string ramp = "G1 Z-2\nG1 X60 Z-6\nG0 Z5\n", first = "T1 M6\nG0 X20 Y20 Z5\n" + ramp;
    const double taken = kBlock - volume(make({"ramp", first, {}, 0.0}, 0.002).solid.part);
    const Golden golden{"ramps", first + "G0 X20 Y30\n" + ramp, {10, 4, 0, 0, 0, 2}, 0.0};
    expect_at({0.05, 0.02, 0.0055}, golden, kBlock - 2.0 * taken, 1e-9);
}

// The arc by which a tool enters an oblique slot, in short lines. Rounding to 1 µm turns each line
// by up to half a degree from the preceding line. The lines, in a vertical plane, leave a single
// wall on each side.
TEST(Recognise, KnowsArcsOfEntryInRoundedLines) {
    const Golden golden{"entry",
                        "T1 M6\nG0 X20.91 Y25.389 Z5\nG1 Z-0.873\nG1 X20.961 Y25.348 Z-0.949\n"
                        "G1 X21.02 Y25.301 Z-1.014\nG1 X21.086 Y25.247 Z-1.066\n"
                        "G1 X21.158 Y25.19 Z-1.104\nG1 X21.233 Y25.129 Z-1.127\n"
                        "G1 X21.311 Y25.067 Z-1.135\nG1 X46.061 Y5.167\nG0 Z5\n",
                        {11, 2, 0, 0, 0, 6},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.0125, 0.005}, golden, left);
}

// A cutter shorter than the depth of its groove moves down an arc in the plane of its axis. Its
// upper end leaves a roof, which the tool cuts through as it retracts. The curve of that cut has
// its ends on the circle where the arc ends, and passes above the circle.
TEST(Recognise, KnowsRoofsThatToolsGoThrough) {
    const Golden golden{"roof",
                        "(TOOL#=6 FLUTE=4 LEN=12 UNIT=METRIC)\nT6 M6\nG0 X45 Y30 Z0\n"
                        "G18 G3 X29 Z-19.596 I-20 K0\nG17\nG0 Z5\n",
                        {9, 1, 0, 0, 0, 0, 2},
                        0.0};
    const double left = volume(make(golden, 0.002).solid.part);
    expect_at({0.05, 0.02, 0.0055}, golden, left);
}

// A ramp leaves the block through a side, where the floor ends in half an ellipse. Readers know the
// ends of the half by angles that are half a turn apart, and choose the half above. So the edge is
// split.
TEST(Recognise, RampsHaveNoEdgesHalfAround) {
    const Golden golden{"ramp_out", "T1 M6\nG0 X60 Y30 Z0\nG1 X100 Z-8\nG0 Z5\n", {}, 0.0};
    const Made made = make(golden, 0.05);
    EXPECT_EQ(made.solid.facets_kept, 0U);
    const Part& part = made.solid.part;
    int ellipses = 0;
    for (const Edge& edge : part.edges) {
        if (!std::holds_alternative<Ellipse>(edge.curve)) continue;
        ++ellipses;
        EXPECT_LT(norm(part.vertices[edge.to] - part.vertices[edge.from]), 6.0);
    }
    EXPECT_EQ(ellipses, 2);
    Part checked = part;
    EXPECT_TRUE(check_part(checked, 1e-9).empty());
    const double left = kBlock - (1250.0 / 3.0 + 50.0 * kPi);
    EXPECT_NEAR(volume(part), left, 1e-9 * left);
}

// A shallow ramp ends in a wall with a vertical axis; their edge is a spline. Readers locate points
// of a long spline so coarsely that they draw nothing of the ramp. So the spline is split.
TEST(Recognise, ShallowRampsHaveShortSplines) {
    const Golden golden{"ramp_into_a_bore",
                        "T1 M6\nG0 X20 Y30 Z5\nG1 Z-2\nG1 X40 Z-2.6\nG0 Z5\n"
                        "G0 X38 Y34\nG1 Z-6\nG0 Z5\n",
                        {},
                        0.0};
    const Part part = make(golden, 0.05).solid.part;
    int splines = 0;
    for (const Face& face : part.faces) {
        const auto* ramp = std::get_if<Extrusion>(&face.surface.form);
        if (!ramp) continue;
        const auto out = [&](std::uint32_t v) {
            const Vec3 p = part.vertices[v];
            return normalized(p - place_along(*ramp, p) * ramp->along - ramp->centre);
        };
        for (const EdgeUse& use : face.loops.front()) {
            const Edge& edge = part.edges[use.edge];
            if (!std::holds_alternative<Spline>(edge.curve)) continue;
            ++splines;
            EXPECT_GT(dot(out(edge.from), out(edge.to)), 0.8);
            // Each half lies on the ramp, as the whole curve does.
            const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
            for (const double t : {0.0, 0.3, 0.7, 1.0})
                EXPECT_NEAR(distance(*ramp, track.at(t)), 0.0, 1e-5);
        }
    }
    EXPECT_GT(splines, 1);
    Part checked = part;
    EXPECT_TRUE(check_part(checked, 1e-4).empty());
}

struct RationalCubic {
    std::array<Vec3, 4> points;
    std::array<double, 4> weights;
    Vec3 at(double t) const {
        const double u = 1.0 - t;
        const std::array shares{u * u * u, 3.0 * t * u * u, 3.0 * t * t * u, t * t * t};
        Vec3 sum;
        double all = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum = sum + (shares[i] * weights[i]) * points[i];
            all += shares[i] * weights[i];
        }
        return (1.0 / all) * sum;
    }
};

// Returns the first rational cubic of a STEP file, in which the four points precede the curve.
RationalCubic first_rational_cubic(const std::string& step) {
    const auto numbers = [&](std::size_t from, auto... into) {
        std::istringstream text(step.substr(from, 200));
        char comma = 0;
        ((text >> *into >> comma), ...);
    };
    RationalCubic cubic;
    const std::string name = "RATIONAL_B_SPLINE_CURVE((", point = "CARTESIAN_POINT('',(";
    const std::size_t at = step.find(name);
    auto& w = cubic.weights;
    numbers(at + name.size(), &w[0], &w[1], &w[2], &w[3]);
    std::size_t before = at;
    for (std::size_t i = 4; i-- > 0;) {
        before = step.rfind(point, before - 1);
        Vec3& p = cubic.points[i];
        numbers(before + point.size(), &p.x, &p.y, &p.z);
    }
    return cubic;
}

// The floor of a nearly level ramp ends in a point between its wall and the start of the next ramp.
// At a place near the wall, points ahead of the path and behind the path have the same height.
// Readers confuse both and draw nothing. So the file has only the front half of the circle. A ramp
// without that point has the whole circle.
TEST(Recognise, ShallowRampsThatEndInAPointAreHalfCirclesInFiles) {
    const auto ramp = [](const std::string& next) {
        return test::make_part(
            setup::job_of({"shallow.nc",
                           "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n"
                           "G21 G90 G17 F300 S5000 M3\nT1 M6\nG0 X28.583 Y27.391 Z5\nG1 Z-1.225\n"
                           "G1 X8.76 Y46.844 Z-1.096\n" +
                               next + "G0 Z5\nM30\n"}),
            0.05);
    };
    const Vec3 ahead = normalized(Vec3{8.76 - 28.583, 46.844 - 27.391, 0});
    const Made alone = ramp(""), ends = ramp("G1 X16.198 Y56.155 Z-7.608\n");
    EXPECT_EQ(alone.step.find("RATIONAL_B_SPLINE_CURVE"), std::string::npos);
    ASSERT_NE(ends.step.find("RATIONAL_B_SPLINE_CURVE"), std::string::npos);
    const RationalCubic curve = first_rational_cubic(ends.step);
    const Vec3 centre = 0.5 * (curve.at(0.0) + curve.at(1.0));
    EXPECT_NEAR(norm(curve.at(0.5) - centre - 3.0 * ahead), 0.0, 1e-6);
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(norm(curve.at(t) - centre), 3.0, 1e-9) << t;
        EXPECT_NEAR(curve.at(t).z, centre.z, 1e-9) << t;
    }
    int halves = 0;
    for (const Face& face : ends.solid.part.faces) {
        const auto half = half_of_ramp(ends.solid.part, face);
        if (!half) continue;
        ++halves;
        EXPECT_NEAR(norm(*half - ahead), 0.0, 1e-6);
        // The parameters of its edges are those of the curve in the file.
        const auto surface = ParameterSurface::of(ends.solid.part, face, nullptr);
        ASSERT_TRUE(surface);
        const auto& along = std::get<Extrusion>(face.surface.form).along;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const Edge& edge = ends.solid.part.edges[use.edge];
                const auto places = surface->curve_of(ends.solid.part, edge);
                ASSERT_TRUE(places);
                const auto& vertices = ends.solid.part.vertices;
                const Vec2 first = places->points.front(), last = places->points.back();
                EXPECT_LT(norm(curve.at(first.x) + first.y * along - vertices[edge.from]), 1e-5);
                EXPECT_LT(norm(curve.at(last.x) + last.y * along - vertices[edge.to]), 1e-5);
                const Track track(edge.curve, vertices[edge.from], vertices[edge.to]);
                for (const double t : {0.0, 0.1, 0.37, 0.5, 0.8, 1.0}) {
                    const Vec3 on = surface->point_on(*places, t);
                    const double miss = std::abs(distance(face.surface.form, track.at(t)));
                    EXPECT_LT(norm(on - track.at(t)), 1.001 * miss + 1.5e-7) << t;
                }
            }
        }
    }
    EXPECT_EQ(halves, 1);
}

// Ramps cross by little more than their rounding, and two of their corners are 2 µm apart. Along
// tangent surfaces, a corner may be off by more than programs round. If both corners merge, they
// are off the adjacent faces, which costs 88 facets instead of 63.
TEST(Recognise, CornersOfRampsStayApart) {
    const Made made = test::make_part(
        setup::job_of({"ramps.nc",
                       "(T1 D=3.175 CR=0. - flat end mill)\n"
                       "(STOCK/BLOCK,14.,14.,9.,-2.,-2.,9.)\nG21 G90 G17 F300 S5000 M3\nT1 M6\n"
                       "G0 X8.379266 Y6.814496 Z5\nG1 Z-4.235128\n"
                       "X7.190038 Y8.003216 Z-4.195353\nX5.955598 Y6.790112 Z-3.599152\n"
                       "X5.807770 Y6.855136 Z-3.577811\nX5.795070 Y6.904920 Z-3.587681\n"
                       "X5.800150 Y6.945814 Z-3.599789\nX5.824534 Y6.990772 Z-3.617882\n"
                       "X7.013254 Y8.180000 Z-4.196001\nX5.824534 Y9.369228 Z-4.244505\n"
                       "X5.807770 Y9.395136 Z-4.248148\nX5.800150 Y9.414440 Z-4.251800\n"
                       "G0 Z5\nM30\n"}),
        0.02);
    // Some facets are triangles of a facet whose corners were moved off its plane.
    EXPECT_LE(made.solid.facets_kept, 75U);
}

}  // namespace
}  // namespace ncsim::brep
