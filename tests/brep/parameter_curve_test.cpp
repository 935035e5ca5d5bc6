// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges for Boolean operations of readers: near enough to their surfaces, and stored in the
// parameters of the surfaces, too.
#include "ncsim/brep/parameter_curve.h"

#include "ncsim/brep/divided_edge.h"
#include "ncsim/brep/edge_deviation.h"
#include "ncsim/brep/long_windings.h"
#include "ncsim/brep/measure.h"

#include "brep/made_part.h"
#include "geometry/contact.h"
#include "query/part_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ncsim::brep {
namespace {

// Calls `visit` for each edge of each face.
template <class Visit>
void for_edges_of_faces(const Part& part, const Visit& visit) {
    for (const Face& face : part.faces) {
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop)
                visit(face, part.edges[use.edge]);
        }
    }
}

// Returns the value of the curve at a share of piece `i`, by de Casteljau.
Vec2 at(const ParameterCurve& curve, std::size_t i, double s) {
    const auto& k = curve.knots;
    const auto place = [&](std::size_t knot) {
        if (knot == 0) return curve.points.front();
        if (knot + 1 == k.size()) return curve.points.back();
        const double before = k[knot] - k[knot - 1], after = k[knot + 1] - k[knot];
        return 1.0 / (before + after) *
               (after * curve.points[2 * knot] + before * curve.points[2 * knot + 1]);
    };
    std::vector<Vec2> row{place(i), curve.points[2 * i + 1], curve.points[2 * i + 2], place(i + 1)};
    for (std::size_t n = row.size(); n > 1; --n) {
        for (std::size_t j = 0; j + 1 < n; ++j)
            row[j] = (1.0 - s) * row[j] + s * row[j + 1];
    }
    return row[0];
}

// A groove of a ball with drilled holes at its side, and a second groove of another depth.
const test::Made& crossing_part() {
    static const test::Made made = test::make_part(
        "crossing",
        "T3 M6\nG0 X-5 Y30 Z5\nG1 Z-5\nG1 X85\nG0 Z5\nG0 X40 Y-5\nG1 Z-6\nG1 Y65\nG0 Z5\n"
        "T2 M6\nG0 X20 Y32 Z5\nG1 Z-15\nG0 Z5\nG0 X60 Y27\nG1 Z-15\nG0 Z5\n");
    return made;
}

TEST(FineSplines, AreAsNearToBothSurfacesAsReadersNeed) {
    const Part& part = crossing_part().solid.part;
    std::size_t splines = 0;
    for_edges_of_faces(part, [&](const Face& face, const Edge& edge) {
        if (!std::holds_alternative<Spline>(edge.curve)) return;
        ++splines;
        const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
        for (int i = 0; i <= 500; ++i)
            EXPECT_LT(std::abs(distance(face.surface.form, track.at(i / 500.0))), 1e-7);
    });
    EXPECT_GE(splines, 8U);
}

TEST(ParameterCurves, AreTheEdgesOnWallsOfBores) {
    const Part& part = crossing_part().solid.part;
    std::size_t curves = 0;
    for_edges_of_faces(part, [&](const Face& face, const Edge& edge) {
        const auto* wall = std::get_if<Cylinder>(&face.surface.form);
        const auto* spline = std::get_if<Spline>(&edge.curve);
        if (!wall || !spline) return;
        const auto surface = ParameterSurface::of(part, face, nullptr);
        ASSERT_TRUE(surface);
        const auto curve = surface->curve_of(part, edge);
        ASSERT_TRUE(curve);
        ++curves;
        const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
        const double begin = spline->knots.front(), length = spline->knots.back() - begin;
        EXPECT_EQ(curve->knots.front(), begin);
        EXPECT_NEAR(curve->knots.back(), begin + length, 1e-12 * length);
        const Frame& frame = face.frame;
        for (std::size_t i = 0; i + 1 < curve->knots.size(); ++i) {
            for (const double s : {0.0, 0.13, 0.5, 0.77, 1.0}) {
                const auto [u, v] = at(*curve, i, s);
                const Vec3 on = frame.origin + v * frame.axis +
                                (wall->radius * std::cos(u)) * frame.x +
                                (wall->radius * std::sin(u)) * cross(frame.axis, frame.x);
                const double t = curve->knots[i] + s * (curve->knots[i + 1] - curve->knots[i]);
                EXPECT_LT(norm(on - track.at((t - begin) / length)), 1.5e-7);
                EXPECT_LT(norm(on - surface->point_on(*curve, (t - begin) / length)), 1e-12);
            }
        }
    });
    EXPECT_GE(curves, 8U);
}

// Programs round, so walls miss edges by micrometres. Readers project such edges badly.
TEST(ParameterCurves, AreTheFeetOfEdgesOffTheirSurface) {
    constexpr double kOff = 1e-4;
    const Part& part = crossing_part().solid.part;
    std::size_t curves = 0;
    for_edges_of_faces(part, [&](Face face, const Edge& edge) {
        auto* wall = std::get_if<Cylinder>(&face.surface.form);
        if (!wall || !std::holds_alternative<Spline>(edge.curve)) return;
        wall->radius += kOff;
        const auto curve = ParameterSurface::of(part, face, nullptr)->curve_of(part, edge);
        ASSERT_TRUE(curve);
        ++curves;
        const Frame& frame = face.frame;
        const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
        const double length = curve->knots.back() - curve->knots.front();
        for (std::size_t i = 0; i + 1 < curve->knots.size(); ++i) {
            for (const double s : {0.0, 0.13, 0.5, 0.77}) {
                const auto [u, v] = at(*curve, i, s);
                const Vec3 out = std::cos(u) * frame.x + std::sin(u) * cross(frame.axis, frame.x);
                const Vec3 on = frame.origin + wall->radius * out + v * frame.axis;
                const double t = curve->knots[i] + s * (curve->knots[i + 1] - curve->knots[i]);
                EXPECT_NEAR(norm(track.at((t - curve->knots.front()) / length) - on), kOff,
                            2e-4 * kOff + 1e-7);
            }
        }
    });
    EXPECT_GE(curves, 8U);
}

TEST(ParameterCurves, AreLeftToReadersForEdgesFartherOffThanProgramsRound) {
    const Part& part = crossing_part().solid.part;
    std::size_t refused = 0;
    for_edges_of_faces(part, [&](Face face, const Edge& edge) {
        auto* wall = std::get_if<Cylinder>(&face.surface.form);
        if (!wall || !std::holds_alternative<Spline>(edge.curve)) return;
        wall->radius += 5e-3;
        EXPECT_FALSE(ParameterSurface::of(part, face, nullptr)->curve_of(part, edge));
        ++refused;
    });
    EXPECT_GE(refused, 8U);
}

// Readers begin an edge at the longer axis of its ellipse with the parameter 0, whatever rounding
// says.
TEST(ParameterCurves, BeginWhereReadersBegin) {
    const Extrusion wall{{1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}, normalized({0.0, 0.6, 0.8}), 3.0};
    const Plane plane{{1.0, 2.0, 3.0}, normalized({0.0, -0.5, 1.0})};
    const auto curve = intersection_curve(wall, plane, {4.0, 2.0, 3.0}, {-2.0, 2.0, 3.0}, {});
    ASSERT_TRUE(curve);
    const Ellipse& ellipse = std::get<Ellipse>(*curve);
    const Vec3 minor = cross(ellipse.axis, ellipse.major);
    for (const double rounding : {-1e-15, 0.0, 1e-15}) {
        Part part;
        part.vertices = {ellipse.centre + ellipse.major_radius * (ellipse.major + rounding * minor),
                         ellipse.centre + ellipse.minor_radius * minor};
        part.edges = {{0, 1, ellipse}};
        Face face;
        face.surface = {wall, true};
        face.frame = {wall.centre, wall.axis, {1.0, 0.0, 0.0}};
        face.loops = {{{0, true}}};
        part.faces = {face};
        const auto found = ParameterSurface::of(part, face, nullptr)->curve_of(part, part.edges[0]);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->knots.front(), 0.0, 1e-9);
        EXPECT_NEAR(found->knots.back(), std::numbers::pi / 2.0, 1e-9);
    }
}

TEST(IntersectionCurve, OfEqualAxesIsACircle) {
    // A plane that cuts the sheared cylinder at the mirrored angle cuts another circle.
    const Vec3 along = normalized({0.0, 3.0, 4.0});
    const Extrusion wall{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, along, 3.175};
    const Vec3 mirrored = normalized(2.0 * dot(along, wall.axis) * along - wall.axis);
    const auto curve = intersection_curve(wall, Plane{{0.0, 0.0, 0.0}, mirrored}, {3.175, 0.0, 0.0},
                                          {-3.175, 0.0, 0.0}, {});
    ASSERT_TRUE(curve);
    ASSERT_TRUE(std::holds_alternative<Circle>(*curve));
    EXPECT_NEAR(std::get<Circle>(*curve).radius, 3.175, 1e-12);
}

TEST(ParameterCurves, AreInTheFileForBothSurfacesOfASpline) {
    const auto count = [&](const char* word) {
        const std::string& text = crossing_part().step;
        std::size_t n = 0;
        for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
            ++n;
        return n;
    };
    EXPECT_GE(count("=SURFACE_CURVE("), 4U);
    EXPECT_EQ(count("=PCURVE("), 2 * count("=SURFACE_CURVE("));
}

// Circles about the axis and lines are no work for readers.
TEST(ParameterCurves, AreNotWrittenForBores) {
    const auto made = test::make_part("bore", "T2 M6\nG0 X20 Y30 Z5\nG1 Z-15\nG0 Z5\n");
    EXPECT_EQ(made.step.find("PCURVE("), std::string::npos);
}

// A groove of a slot mill that goes three times round a bore.
TEST(LongWindings, AreDividedInTheFileAlone) {
    setup::JobOptions options;
    for (const char* text : {"T1=flat:D10:L30", "T2=slot:D12:L1"}) {
        std::string message;
        options.tools.push_back(toolpath::parse_tool_option(text, message).value());
    }
    const auto made = test::make_part(
        setup::job_of({"helix.nc",
                       "(STOCK/BLOCK,44.,44.,18.,22.,22.,18.)\nG21 G90 G17\nT1 M6\nS3000 M3\n"
                       "G0 X0 Y0 Z5\nG1 Z-19 F300\nG1 X5.5 F500\nG3 X5.5 Y0 I-5.5 J0\nG1 X0\n"
                       "G0 Z50\nT2 M6\nG0 X0 Y0 Z5\nG0 Z-14\nG1 X6.2 F200\n"
                       "G3 X6.2 Y0 Z-12.2 I-6.2 J0\nG3 X6.2 Y0 Z-10.4 I-6.2 J0\n"
                       "G3 X6.2 Y0 Z-8.6 I-6.2 J0\nG1 X0\nG0 Z50\nM30\n"},
                      options),
        0.05);
    const Part& whole = made.solid.part;
    EXPECT_EQ(whole.faces.size(), 14U);
    ASSERT_TRUE(has_long_windings(whole));
    Part divided = whole;
    split_long_windings(divided);
    EXPECT_FALSE(has_long_windings(divided));
    EXPECT_EQ(divided.faces.size(), 41U);
    EXPECT_TRUE(check_part(divided, 1e-6).empty());
    EXPECT_NEAR(mass_of(divided).volume, mass_of(whole).volume, 1e-6);
    std::size_t in_file = 0;
    for (std::size_t i = made.step.find("=ADVANCED_FACE("); i != std::string::npos;
         i = made.step.find("=ADVANCED_FACE(", i + 1))
        ++in_file;
    EXPECT_EQ(in_file, divided.faces.size());
}

// A bore and a thread of one turn are not divided.
TEST(LongWindings, AreMoreThanATurn) {
    EXPECT_FALSE(has_long_windings(crossing_part().solid.part));
}

// A chord of a cylinder of radius 5 about Y, at the height Z4.9999: 1e-4 mm inside above the axis.
std::optional<double> unmeasured_on_chord(double from, double to, double height = 4.9999) {
    Part part;
    part.vertices = {{from, 0.0, height}, {to, 0.0, height}};
    part.edges = {{0, 1, Line{}}};
    const Form cylinder = Cylinder{{}, {0.0, 1.0, 0.0}, 5.0};
    EdgeDeviation deviation(part, part.edges[0]);
    deviation.add(cylinder);
    EXPECT_NEAR(deviation.at(from / (from - to)), 5.0 - height, 1e-12);
    return deviation.unmeasured_maximum();
}

TEST(EdgeDeviation, IsFoundBetweenThePlacesThatReadersMeasure) {
    const double half = std::sqrt(25.0 - 4.9999 * 4.9999);
    for (const double to : {0.3 * half, 0.65 * half, 0.9 * half}) {
        const auto place = unmeasured_on_chord(-half, to);
        ASSERT_TRUE(place) << to;
        EXPECT_NEAR(*place, half / (half + to), 1e-5) << to;
    }
}

TEST(EdgeDeviation, HasNoVertexWhereReadersMeasure) {
    const double half = std::sqrt(25.0 - 4.9999 * 4.9999);
    EXPECT_FALSE(unmeasured_on_chord(-half, half)) << "in the middle";
    EXPECT_FALSE(unmeasured_on_chord(-half, half * 8.0 / 14.0)) << "at 14 of 22";
    EXPECT_FALSE(unmeasured_on_chord(-half, 5e-5)) << "too near to the end";
}

TEST(EdgeDeviation, HasNoVertexOnEdgesThatReadersTakeForExact) {
    EXPECT_FALSE(unmeasured_on_chord(-1e-4, 0.37e-4, 5.0 - 0.9e-7));
}

// Halves of an edge and of its curves in parameters are divided at the same place.
TEST(DividedEdge, HasTheCurvesOfTheEdge) {
    const Part& part = crossing_part().solid.part;
    std::size_t curves = 0;
    for_edges_of_faces(part, [&](const Face& face, const Edge& edge) {
        if (!std::holds_alternative<Cylinder>(face.surface.form)) return;
        const auto surface = ParameterSurface::of(part, face, nullptr);
        const auto curve = surface->curve_of(part, edge);
        if (!curve) return;
        ++curves;
        for (const double at : {0.123, 0.5, 0.98}) {
            const EdgeHalves halves = divide_edge(part, edge, at);
            const auto in_parameters = divide_curve(*curve, part, edge, at);
            Part ends;
            ends.vertices = {part.vertices[edge.from], halves.middle, part.vertices[edge.to]};
            ends.edges = {{0, 1, halves.first}, {1, 2, halves.second}};
            for (std::size_t i = 0; i < 2; ++i) {
                const Edge& half = ends.edges[i];
                const auto again = surface->curve_of(ends, half);
                ASSERT_TRUE(again);
                EXPECT_NEAR(in_parameters[i].knots.front(), again->knots.front(), 1e-9);
                EXPECT_NEAR(in_parameters[i].knots.back(), again->knots.back(), 1e-9);
                const Track track(half.curve, ends.vertices[half.from], ends.vertices[half.to]);
                for (const double t : {0.0, 0.3, 0.8, 1.0})
                    EXPECT_LT(norm(surface->point_on(in_parameters[i], t) - track.at(t)), 1.5e-7);
            }
        }
    });
    EXPECT_GE(curves, 8U);
}

// A circle in a file has its radius, also if its ends miss the circle.
TEST(PointInFile, IsOnTheCircle) {
    const Curve curve = Circle{{}, {0.0, 0.0, 1.0}, 2.0};
    const Vec3 from{2.001, 0.0, 0.0}, to{0.0, 2.001, 0.0};
    const Track track(curve, from, to);
    EXPECT_NEAR(norm(track.at(0.3)), 2.001, 1e-12);
    EXPECT_NEAR(norm(point_in_file(track, track.at(0.3))), 2.0, 1e-12);
}

}  // namespace
}  // namespace ncsim::brep
