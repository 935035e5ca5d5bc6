// SPDX-License-Identifier: GPL-3.0-or-later
//
// Topology and repairs on solids made by hand: what is sound stays as it is, divided edges bound
// the same solid, and shells nest as boxes do.
#include "ncsim/brep/measure.h"

#include "brep/solids.h"
#include "geometry/no_index.h"
#include "heal/degenerate_planes.h"
#include "heal/fine_splines.h"
#include "heal/non_simple_faces.h"
#include "heal/nonplanar_faces.h"
#include "heal/pinched_faces.h"
#include "heal/reader_compatibility.h"
#include "heal/short_edges.h"
#include "heal/spikes.h"
#include "heal/tangent_holes.h"
#include "query/part_check.h"
#include "topology/axes.h"
#include "topology/chords.h"
#include "topology/crossings.h"
#include "topology/edge_splitter.h"
#include "topology/nesting.h"
#include "topology/whole_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr Vec3 kUp{0, 0, 1};

// --- Sound solids ---

std::vector<std::uint32_t> all_faces(const Part& part) {
    std::vector<std::uint32_t> faces(part.faces.size());
    std::iota(faces.begin(), faces.end(), 0U);
    return faces;
}

TEST(Repairs, LeaveSoundSolidsAsTheyAre) {
    using Repair = std::function<bool(Part&)>;
    const std::vector<std::pair<const char*, Repair>> repairs{
        {"spikes", [](Part& p) { return remove_spikes(p); }},
        {"short edges", [](Part& p) { return collapse_short_edges(p, all_faces(p), 1e-3); }},
        {"touching", [](Part& p) { return join_touching_corners(p, all_faces(p), 1e-3); }},
        {"non-simple", [](Part& p) { return !split_non_simple_faces(p).empty(); }},
        {"nonplanar", [](Part& p) { return !triangulate_nonplanar_faces(p).empty(); }},
        {"degenerate", [](Part& p) { return !degenerate_planes(p).empty(); }},
        {"crossed", [](Part& p) { return !crossed_planes(p).empty(); }},
        {"pinched",
         [](Part& p) {
             split_pinched_faces(p);
             return false;
         }},
        {"tangent holes",
         [](Part& p) {
             split_faces_at_tangent_holes(p);
             return false;
         }},
        {"base circles", [](Part& p) {
             split_cones_at_base_circle(p);
             return false;
         }}};
    for (const test::NamedPart& solid : test::solids()) {
        for (const auto& [name, repair] : repairs) {
            SCOPED_TRACE(solid.name + ": " + name);
            Part part = solid.part;
            EXPECT_FALSE(repair(part));
            EXPECT_EQ(part.vertices, solid.part.vertices);
            ASSERT_EQ(part.edges.size(), solid.part.edges.size());
            for (std::size_t e = 0; e < part.edges.size(); ++e)
                EXPECT_EQ(part.edges[e].curve, solid.part.edges[e].curve);
            EXPECT_EQ(part.faces.size(), solid.part.faces.size());
        }
        for (const Face& face : solid.part.faces) {
            EXPECT_FALSE(is_nonplanar(solid.part, face));
            EXPECT_FALSE(touches_base_circle(solid.part, face));
        }
    }
}

// Each operation divides edges only, so the solid stays the same.
TEST(Repairs, DividedEdgesBoundTheSameSolid) {
    const auto halves = [](double at) {
        return [at](Part& p) {
            EdgeSplitter splitter(p);
            const auto edges = static_cast<std::uint32_t>(p.edges.size());
            for (std::uint32_t e = 0; e < edges; ++e) {
                const bool is_line = std::holds_alternative<Line>(p.edges[e].curve);
                EXPECT_EQ(splitter.divide(e, at), !is_line);
                EXPECT_FALSE(splitter.divide(e, at)) << "divided before, or a line";
            }
            EXPECT_FALSE(splitter.halve(static_cast<std::uint32_t>(p.edges.size()) - 1));
            splitter.finish();
        };
    };
    const std::vector<std::pair<const char*, std::function<void(Part&)>>> divisions{
        {"in the middle", halves(0.5)},
        {"near the start", halves(0.1)},
        {"wide edges", [](Part& p) { split_wide_edges(p); }},
        {"arcs near corners", [](Part& p) { split_arcs_near_corners(p); }},
        {"arcs at cusps", [](Part& p) { split_arcs_at_cusps(p); }},
        {"fine splines", [](Part& p) { refine_splines(p); }}};
    for (const test::NamedPart& solid : test::solids()) {
        for (const auto& [name, divide] : divisions) {
            SCOPED_TRACE(solid.name + ": " + name);
            Part part = solid.part;
            divide(part);
            for (const Fault& fault : check_part(part, 1e-9))
                ADD_FAILURE() << fault.face << ": " << fault.what;
            EXPECT_NEAR(volume(part), solid.volume, 1e-12 * solid.volume);
            EXPECT_EQ(static_cast<int>(part.faces.size()), solid.faces);
            EXPECT_GE(part.edges.size(), solid.part.edges.size());
        }
    }
}

// --- Faults of facets ---

/// A level face at the height 0 with the corners of `loops`, whose edges are its own.
Part level_face(const std::vector<std::vector<Vec3>>& loops) {
    Part part;
    Face face;
    face.surface.form = Plane{{}, kUp};
    face.frame = {{}, kUp, {1, 0, 0}};
    for (const std::vector<Vec3>& corners : loops) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        const auto count = static_cast<std::uint32_t>(corners.size());
        Loop& loop = face.loops.emplace_back();
        for (std::uint32_t i = 0; i < count; ++i) {
            part.vertices.push_back(corners[i]);
            loop.push_back({static_cast<std::uint32_t>(part.edges.size()), true});
            part.edges.push_back({first + i, first + (i + 1) % count, Line{}});
        }
    }
    part.faces.push_back(face);
    part.solids.push_back({{0}, {}});
    return part;
}

TEST(CrossedPlanes, AreThoseWithCrossingTouchingOrInvertedLoops) {
    const std::vector<Vec3> square{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    const auto hole = [](double x, double y, double size) {
        return std::vector<Vec3>{
            {x, y, 0}, {x, y + size, 0}, {x + size, y + size, 0}, {x + size, y, 0}};
    };
    struct Row {
        const char* name;
        std::vector<std::vector<Vec3>> loops;
        bool is_crossed;
    };
    std::vector<Vec3> inverted(square.rbegin(), square.rend());
    std::vector<Vec3> wrong_hole = hole(3, 3, 2);
    std::ranges::reverse(wrong_hole);
    for (const Row& row : {
             Row{"square", {square}, false},
             Row{"hole", {square, hole(3, 3, 2)}, false},
             Row{"two holes", {square, hole(1, 1, 2), hole(5, 5, 2)}, false},
             Row{"holes 1 µm apart", {square, hole(1, 1, 2), hole(3.001, 1, 2)}, false},
             Row{"holes that cross", {square, hole(1, 1, 2), hole(2, 2, 2)}, true},
             Row{"hole across the outline", {square, hole(9, 3, 2)}, true},
             Row{"hole that touches", {square, hole(8, 3, 2 - 1e-7)}, true},
             Row{"inverted outline", {inverted}, true},
             Row{"inverted hole", {square, wrong_hole}, true},
             Row{"bow tie", {{{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10, 0}}}, true},
             Row{"concave", {{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}, {0, 10, 0}}}, false},
         }) {
        // Turned and moved, the answer is the same.
        for (const double degrees : {0.0, 37.0, 90.0}) {
            SCOPED_TRACE(testing::Message() << row.name << ' ' << degrees);
            const double a = degrees * std::numbers::pi / 180;
            auto loops = row.loops;
            for (auto& loop : loops) {
                for (Vec3& p : loop)
                    p = {std::cos(a) * p.x - std::sin(a) * p.y + 3,
                         std::sin(a) * p.x + std::cos(a) * p.y - 7, 0};
            }
            const Part part = level_face(loops);
            EXPECT_EQ(crossed_planes(part), row.is_crossed ? std::vector<std::uint32_t>{0}
                                                           : std::vector<std::uint32_t>{});
            EXPECT_EQ(degenerate_planes(part).empty(), !row.is_crossed);
        }
    }
}

TEST(Encloses, HoldsForLoopsInside) {
    const Part part = level_face({{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, 2, 0}, {0, 10, 0}},
                                  {{1, 1, 0}, {1, 2, 0}, {2, 1, 0}},
                                  {{4, 5, 0}, {4, 6, 0}, {5, 5, 0}},
                                  {{20, 1, 0}, {20, 2, 0}, {21, 1, 0}}});
    const Face& face = part.faces[0];
    EXPECT_TRUE(encloses(part, face, face.loops[0], face.loops[1]));
    EXPECT_FALSE(encloses(part, face, face.loops[0], face.loops[2])) << "in the notch";
    EXPECT_FALSE(encloses(part, face, face.loops[0], face.loops[3]));
    EXPECT_FALSE(encloses(part, face, face.loops[1], face.loops[0]));
}

TEST(Spikes, EdgesThereAndBackGo) {
    // A square with a spike from (10, 5) to (14, 5) and back.
    Part part = level_face({{{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {10, 10, 0}, {0, 10, 0}}});
    part.vertices.push_back({14, 5, 0});
    part.edges.push_back({2, 5, Line{}});
    Loop& loop = part.faces[0].loops[0];
    loop.insert(loop.begin() + 2, {{5, true}, {5, false}});
    EXPECT_TRUE(remove_spikes(part));
    ASSERT_EQ(part.faces[0].loops.size(), 1U);
    std::set<std::uint32_t> edges;
    for (const EdgeUse& use : part.faces[0].loops[0])
        edges.insert(use.edge);
    EXPECT_EQ(edges, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_FALSE(remove_spikes(part)) << "once";
}

TEST(ShortEdges, EndsBecomeOneCorner) {
    for (const double length : {1e-4, 9e-4, 1.1e-3}) {
        Part part = level_face({{{0, 0, 0}, {10, 0, 0}, {10, length, 0}, {10, 10, 0}, {0, 10, 0}}});
        const bool is_short = length < 1e-3;
        EXPECT_EQ(collapse_short_edges(part, {0}, 1e-3), is_short) << length;
        EXPECT_EQ(part.faces[0].loops[0].size(), is_short ? 4U : 5U);
        EXPECT_FALSE(collapse_short_edges(part, {0}, 1e-3));
    }
    Part part = level_face({{{0, 0, 0}, {10, 0, 0}, {10, 1e-4, 0}, {10, 10, 0}}});
    EXPECT_FALSE(collapse_short_edges(part, {}, 1e-3)) << "of other faces";
}

TEST(NonSimpleFaces, LoopsThatReturnToACornerBecomeFaces) {
    // Two triangles that meet in the corner 0: one loop that comes back to it.
    Part part;
    part.vertices = {{0, 0, 0}, {4, -2, 0}, {4, 2, 0}, {-4, 2, 0}, {-4, -2, 0}};
    part.edges = {{0, 1, Line{}}, {1, 2, Line{}}, {2, 0, Line{}},
                  {0, 3, Line{}}, {3, 4, Line{}}, {4, 0, Line{}}};
    Face face;
    face.surface.form = Plane{{}, kUp};
    face.frame = {{}, kUp, {1, 0, 0}};
    face.loops = {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}}};
    part.faces = {face};
    part.solids = {{{0}, {}}};
    EXPECT_EQ(split_non_simple_faces(part), std::vector<std::uint32_t>{0});
    ASSERT_EQ(part.faces.size(), 2U);
    EXPECT_EQ(part.solids[0].outside, (Shell{0, 1}));
    double area = 0.0;
    for (const Face& piece : part.faces) {
        ASSERT_EQ(piece.loops.size(), 1U);
        EXPECT_EQ(piece.loops[0].size(), 3U);
        area += measure(part, piece, {}).area;
    }
    EXPECT_NEAR(area, 16.0, 1e-12);
}

/// A cube of 10 mm, from the origin, as a solid of six faces.
Part cube_of_faces();

TEST(NonplanarFaces, BecomeTrianglesThatCoverTheFacet) {
    for (const double lift : {0.5e-4, 0.05}) {
        Part part = cube_of_faces();
        // The corner moves within its walls and off the top.
        const auto corner = std::ranges::find(part.vertices, Vec3{10, 10, 10});
        ASSERT_NE(corner, part.vertices.end());
        corner->z += lift;
        for (Face& face : part.faces)
            face.is_facet = true;
        const bool is_warped = lift > 1e-4;
        EXPECT_EQ(std::ranges::any_of(part.faces,
                                      [&](const Face& face) { return is_nonplanar(part, face); }),
                  is_warped);
        EXPECT_EQ(!triangulate_nonplanar_faces(part).empty(), is_warped);
        double above = 0.0, below = 0.0;
        for (const Face& face : part.faces) {
            EXPECT_FALSE(is_nonplanar(part, face));
            const double level =
                measure(part, face, {}).area * std::get<Plane>(face.surface.form).normal.z;
            (level > 0.0 ? above : below) += level;
        }
        EXPECT_NEAR(above, 100.0, 1e-3) << "seen from above, the triangles cover the facet";
        EXPECT_NEAR(below, -100.0, 1e-9);
        EXPECT_EQ(part.solids[0].outside.size(), part.faces.size());
        EXPECT_TRUE(check_part(part, 1e-4).empty());
    }
}

// --- Nesting ---

/// Adds the surface of a cube of `size` mm about `centre` as a shell; outwards, or inwards.
void add_cube(cda::Boundary& boundary, Vec3 centre, double size, bool outwards) {
    const auto first = static_cast<std::uint32_t>(boundary.vertices.size());
    for (int i = 0; i < 8; ++i) {
        boundary.vertices.push_back(
            centre + (size / 2) * Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    }
    const std::uint32_t shell = boundary.shells++;
    for (const std::array<std::uint32_t, 4>& q : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                                  {4, 5, 7, 6},
                                                  {0, 1, 5, 4},
                                                  {2, 6, 7, 3},
                                                  {0, 4, 6, 2},
                                                  {1, 3, 7, 5}}) {
        std::vector<std::uint32_t> loop;
        for (const std::uint32_t corner : q)
            loop.push_back(first + corner);
        if (!outwards) std::ranges::reverse(loop);
        cda::BoundaryFace face;
        face.loops = {loop};
        face.shell = shell;
        boundary.faces.push_back(face);
    }
}

Part cube_of_faces() {
    cda::Boundary boundary;
    add_cube(boundary, {5, 5, 5}, 10, true);
    for (cda::BoundaryFace& face : boundary.faces) {
        const std::vector<std::uint32_t>& loop = face.loops[0];
        const Vec3 a = boundary.vertices[loop[0]];
        face.normal =
            normalized(cross(boundary.vertices[loop[1]] - a, boundary.vertices[loop[2]] - a));
        face.offset = dot(face.normal, a);
    }
    return faceted(boundary, std::vector<std::vector<cda::Origin>>(6, {cda::kStockOrigin}));
}

std::string text_of(const std::vector<Nesting>& solids) {
    std::string text;
    for (const Nesting& solid : solids) {
        text += std::to_string(solid.outside) + "(";
        for (const std::uint32_t s : solid.voids)
            text += std::to_string(s);
        text += ")";
    }
    return text;
}

TEST(Nesting, VoidsBelongToTheInnermostSolid) {
    EXPECT_TRUE(nesting_of({}).empty());
    struct Cube {
        Vec3 centre;
        double size;
        bool outwards;
    };
    struct Row {
        std::vector<Cube> cubes;
        std::string nesting;
    };
    const Vec3 o{}, far{200, 0, 0};
    for (const Row& row : {
             Row{{{o, 100, true}}, "0()"},
             Row{{{o, 100, false}}, "0()"},  // a void alone
             Row{{{o, 100, true}, {far, 100, true}}, "0()1()"},
             Row{{{o, 100, true}, {{20, 0, 0}, 10, false}, {{-20, 0, 0}, 10, false}}, "0(12)"},
             Row{{{{20, 0, 0}, 10, false}, {o, 100, true}, {far, 50, true}, {far, 9, false}},
                 "1(0)2(3)"},
             // An island in a void, with a void of its own.
             Row{{{o, 100, true}, {o, 60, false}, {o, 40, true}, {o, 20, false}}, "0(1)2(3)"},
             Row{{{o, 20, false}, {o, 40, true}, {o, 60, false}, {o, 100, true}}, "1(0)3(2)"},
         }) {
        cda::Boundary boundary;
        for (const Cube& cube : row.cubes)
            add_cube(boundary, cube.centre, cube.size, cube.outwards);
        EXPECT_EQ(text_of(nesting_of(boundary)), row.nesting);
        const auto shells = shells_of(boundary);
        ASSERT_EQ(shells.size(), row.cubes.size());
        for (std::uint32_t s = 0; s < shells.size(); ++s) {
            ASSERT_EQ(shells[s].size(), 6U);
            EXPECT_EQ(shells[s].front(), 6 * s);
        }
    }
}

// --- Crossings with a plane ---

TEST(Crossings, OfACircleAreWhereItPassesThePlane) {
    // An upright circle of radius 5 about the origin, from its rightmost point.
    Part part;
    part.vertices = {{5, 0, 0}};
    part.edges = {{0, 0, Circle{{}, {0, -1, 0}, 5}}};
    for (const double z : {-6.0, -4.0, 0.5, 3.0, 4.999, 5.001}) {
        SCOPED_TRACE(z);
        const auto found = crossings_of(part, part.edges[0], {kUp, z}, 0.0);
        const bool meets = std::abs(z) < 5;
        ASSERT_EQ(found.size(), meets ? 2U : 0U);
        if (!meets) continue;
        const double x = std::sqrt(25 - z * z);
        int up = 0;
        for (const Crossing& crossing : found) {
            EXPECT_NEAR(crossing.at.z, z, 1e-9);
            EXPECT_NEAR(crossing.at.x, crossing.goes_up ? x : -x, 1e-7);
            EXPECT_NEAR(norm(crossing.above - crossing.at), 0.0, 1e-7);
            up += crossing.goes_up ? 1 : -1;
        }
        EXPECT_EQ(up, 0) << "a closed edge rises as often as it falls";
    }
}

TEST(Crossings, OfALineAndItsReverse) {
    Part part;
    part.vertices = {{0, 0, -1}, {10, 0, 3}};
    part.edges = {{0, 1, Line{}}, {1, 0, Line{}}};
    for (const double lift : {0.0, 0.1}) {
        const auto there = crossings_of(part, part.edges[0], {kUp, 1.0}, lift);
        const auto back = crossings_of(part, part.edges[1], {kUp, 1.0}, lift);
        ASSERT_EQ(there.size(), 1U);
        ASSERT_EQ(back.size(), 1U);
        EXPECT_TRUE(there[0].goes_up);
        EXPECT_FALSE(back[0].goes_up);
        for (const Crossing& crossing : {there[0], back[0]}) {
            EXPECT_NEAR(norm(crossing.at - Vec3{5, 0, 1}), 0.0, 1e-9);
            EXPECT_NEAR(crossing.above.z, 1.0 + lift, 1e-9);
        }
    }
    EXPECT_TRUE(crossings_of(part, part.edges[0], {kUp, 4.0}, 0.0).empty());
    EXPECT_TRUE(crossings_of(part, part.edges[0], {kUp, 2.95}, 0.1).empty())
        << "not higher than the lift";
}

// A face between an arc of radius 100 and a line or another arc. Its width is 0.02 or 0.5 mm.
TEST(SplitEdgesOfLenses, HalvesTheArcsOfNarrowFacesOnly) {
    for (const double width : {0.02, 0.5}) {
        const double half = std::sqrt(100.0 * 100.0 - (100.0 - width) * (100.0 - width));
        Part part;
        part.vertices = {{-half, 100.0 - width, 0}, {half, 100.0 - width, 0}};
        const Edge arc{1, 0, Circle{{}, kUp, 100.0}};
        const Edge below{0, 1, Circle{{0, 200.0 - 2.0 * width, 0}, kUp, 100.0}};
        part.edges = {{0, 1, Line{}}, arc, below};
        Face segment, lens;
        segment.surface.form = lens.surface.form = Plane{{}, kUp};
        segment.loops = {{{0, true}, {1, true}}};
        lens.loops = {{{1, true}, {2, true}}};
        part.faces = {segment};
        split_edges_of_lenses(part);
        const bool is_narrow = width < 0.1;
        ASSERT_EQ(part.faces[0].loops[0].size(), is_narrow ? 3U : 2U) << "lines stay";
        if (is_narrow) {
            EXPECT_NEAR(part.vertices.back().y, 100.0, 1e-9);
        }
        part.vertices.resize(2);
        part.edges = {{0, 1, Line{}}, arc, below};
        part.faces = {lens};
        split_edges_of_lenses(part);
        EXPECT_EQ(part.faces[0].loops[0].size(), is_narrow ? 4U : 2U);
    }
}

// --- Edges and circles ---

TEST(SplitEdge, HalvesLieOnTheCurve) {
    Part part;
    part.vertices = {{5, 0, 0}, {0, 5, 0}, {0, 0, 0}, {9, 0, 0}};
    part.edges = {
        {0, 1, Circle{{}, kUp, 5}},
        {0, 0, Circle{{}, kUp, 5}},
        {2, 3, Line{}},
        {2, 3, Spline{{{0, 0, 0}, {3, 1, 0}, {6, 1, 0}, {9, 0, 0}}, {0, 1}}},
        {2, 3,
         Spline{{{0, 0, 0}, {1, 2, 0}, {3, 3, 0}, {6, 3, 0}, {8, 2, 0}, {9, 0, 0}}, {0, 1, 2.5}}}};
    for (const double at : {0.25, 0.5, 0.75}) {
        const auto quarter = split_edge(part, part.edges[0], at);
        const double a = at * std::numbers::pi / 2;
        EXPECT_NEAR(norm(quarter->middle - Vec3{5 * std::cos(a), 5 * std::sin(a), 0}), 0, 1e-12);
        const auto whole = split_edge(part, part.edges[1], at);
        EXPECT_NEAR(norm(whole->middle - Vec3{5 * std::cos(4 * a), 5 * std::sin(4 * a), 0}), 0,
                    1e-12);
    }
    EXPECT_FALSE(split_edge(part, part.edges[2]));
    EXPECT_FALSE(split_edge(part, part.edges[3])) << "no inner knot";
    const Track whole(part.edges[4].curve, {0, 0, 0}, {9, 0, 0});
    const auto halves = split_edge(part, part.edges[4]);
    ASSERT_TRUE(halves);
    EXPECT_NEAR(norm(halves->middle - whole.at(0.4)), 0.0, 1e-12) << "at the inner knot";
    const Track first(halves->first, {0, 0, 0}, halves->middle);
    const Track second(halves->second, halves->middle, {9, 0, 0});
    for (const double t : {0.1, 0.5, 0.9}) {
        EXPECT_NEAR(norm(first.at(t) - whole.at(0.4 * t)), 0.0, 1e-12);
        EXPECT_NEAR(norm(second.at(t) - whole.at(0.4 + 0.6 * t)), 0.0, 1e-12);
    }
    // At any place, a spline without an inner knot becomes two pieces of the same curve.
    const Part before = part;
    EdgeSplitter splitter(part);
    ASSERT_TRUE(splitter.divide(3, 0.3));
    const Track old(before.edges[3].curve, {0, 0, 0}, {9, 0, 0});
    const Vec3 middle = part.vertices[part.edges[3].to];
    EXPECT_NEAR(norm(middle - old.at(0.3)), 0.0, 1e-12);
    const Track low(part.edges[3].curve, {0, 0, 0}, middle);
    const Track high(part.edges.back().curve, middle, {9, 0, 0});
    for (const double t : {0.2, 0.7}) {
        EXPECT_NEAR(norm(low.at(t) - old.at(0.3 * t)), 0.0, 1e-12);
        EXPECT_NEAR(norm(high.at(t) - old.at(0.3 + 0.7 * t)), 0.0, 1e-12);
    }
}

TEST(WholeCircle, IsALoopOfOneClosedCircle) {
    Part part;
    part.vertices = {{13, 4, 7}, {3, 4, 7}};
    part.edges = {{0, 0, Circle{{8, 4, 7}, kUp, 5}}, {0, 1, Circle{{8, 4, 7}, kUp, 5}}};
    const auto forward = whole_circle(part, {{0, true}}), back = whole_circle(part, {{0, false}});
    ASSERT_TRUE(forward && back);
    EXPECT_EQ(forward->centre, (Vec3{8, 4, 7}));
    EXPECT_EQ(forward->axis, kUp);
    EXPECT_EQ(back->axis, -kUp) << "as the face uses the edge";
    EXPECT_EQ(forward->radius, 5.0);
    EXPECT_TRUE(forward->is_about({8, 4, -100}, kUp));
    EXPECT_TRUE(forward->is_about({8, 4, 0}, -kUp));
    EXPECT_FALSE(forward->is_about({8, 4.001, 0}, kUp));
    EXPECT_FALSE(forward->is_about({8, 4, 7}, {1, 0, 0}));
    EXPECT_FALSE(whole_circle(part, {}));
    EXPECT_FALSE(whole_circle(part, {{1, true}})) << "an arc";
    EXPECT_FALSE(whole_circle(part, {{1, true}, {1, false}}));
}

TEST(Axes, CoordinatesOfARotatedFrame) {
    const Axes axes(Vec3{1, 2, 3}, Frame{{}, {0, 1, 0}, {0, 0, 1}});
    const Local p = axes({1 + 4, 2 + 7, 3 + 3});
    EXPECT_EQ(p.x, 3.0);
    EXPECT_EQ(p.y, 4.0);
    EXPECT_EQ(p.z, 7.0);
    EXPECT_EQ(p.radius, 5.0);
    // In its axes, an extrusion is a cylinder: the centre of each circle is on the axis.
    const Vec3 along = normalized({3, 0, 4});
    const Axes oblique(Extrusion{{}, kUp, along, 2.0}, Frame{{}, kUp, {1, 0, 0}});
    for (const double far : {-10.0, 0.0, 25.0}) {
        const Local on = oblique(far * along + Vec3{0, 2, 0});
        EXPECT_NEAR(on.radius, 2.0, 1e-12);
        EXPECT_NEAR(on.z, far, 1e-12);
    }
}

}  // namespace
}  // namespace ncsim::brep
