// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the check of parts with defects in loops, edges and faces, and the repair of vertices that
// are too close.
#include "query/part_check.h"

#include "ncsim/brep/measure.h"

#include "brep/solids.h"
#include "heal/vertex_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr double kTolerance = 1e-9;

std::string text_of(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults)
        text += "face " + std::to_string(fault.face) + ": " + fault.what + "\n";
    return text;
}

TEST(Check, FindsNothingAgainstSoundSolids) {
    for (test::NamedPart& solid : test::solids()) {
        SCOPED_TRACE(solid.name);
        EXPECT_EQ(text_of(check_part(solid.part, kTolerance)), "");
        EXPECT_LT(solid.part.miss_mm, 1e-13);
    }
}

TEST(Check, MeasuresVolumesAsOnPaper) {
    for (const test::NamedPart& solid : test::solids()) {
        SCOPED_TRACE(solid.name);
        EXPECT_NEAR(volume(solid.part), solid.volume, 1e-12 * solid.volume);
    }
}

test::NamedPart solid_named(const std::string& name) {
    for (test::NamedPart& solid : test::solids()) {
        if (solid.name == name) return std::move(solid);
    }
    return {};
}

// Returns a part with a single planar face that has n × n square holes. The edges are the sides of
// the loops, four per loop.
Part face_with_holes(int n) {
    Part part;
    Face face;
    face.surface.form = Plane{{0, 0, 0}, {0, 0, 1}};
    face.frame = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const auto add_loop = [&](const std::vector<Vec3>& corners) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        const auto count = static_cast<std::uint32_t>(corners.size());
        Loop& loop = face.loops.emplace_back();
        for (std::uint32_t i = 0; i < count; ++i) {
            part.vertices.push_back(corners[i]);
            loop.push_back({static_cast<std::uint32_t>(part.edges.size()), true});
            part.edges.push_back({first + i, first + (i + 1) % count, Line{}});
        }
    };
    const double size = 4.0 * n;
    add_loop({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
    for (int i = 0; i < n * n; ++i) {
        const double x = 4.0 * (i % n) + 1.0, y = 4.0 * (i / n) + 1.0;
        add_loop({{x, y, 0}, {x, y + 2, 0}, {x + 2, y + 2, 0}, {x + 2, y, 0}});
    }
    part.faces.push_back(std::move(face));
    return part;
}

TEST(Check, FindsTheOneHoleOfManyThatMeetsAnother) {
    constexpr int kHoles = 20;
    const Part sound = face_with_holes(kHoles);
    double miss = 0.0;
    EXPECT_EQ(text_of(faults_of(sound, 0, kTolerance, miss)), "");
    // Moves every seventh hole onto a neighbour in three directions: within a strip of the plane
    // and across the border of two strips.
    for (int hole = 0; hole < kHoles * kHoles; hole += 7) {
        for (const Vec3 way : {Vec3{2.5, 0, 0}, Vec3{-2.5, 0, 0}, Vec3{0, 2.5, 0}}) {
            Part part = sound;
            std::vector<std::uint32_t> moved;
            for (std::uint32_t i = 0; i < 4; ++i) {
                moved.push_back(static_cast<std::uint32_t>(4 + 4 * hole) + i);
                part.vertices[moved.back()] = part.vertices[moved.back()] + way;
            }
            const auto faults = faults_of(part, 0, kTolerance, miss);
            ASSERT_EQ(faults.size(), 1U) << "hole " << hole;
            EXPECT_EQ(faults.front().what, kCrossOrTouch);
            EXPECT_TRUE(std::ranges::any_of(
                faults.front().edges,
                [&](std::uint32_t edge) { return std::ranges::find(moved, edge) != moved.end(); }))
                << "hole " << hole;
        }
    }
}

TEST(Check, FindsALoopTheWrongWayRound) {
    Part part = solid_named("cylinder").part;
    for (Loop& loop : part.faces[1].loops) {
        for (EdgeUse& use : loop)
            use.is_forward = !use.is_forward;
    }
    EXPECT_NE(text_of(check_part(part, kTolerance)), "");
}

TEST(Check, FindsAnEdgeOffItsSurface) {
    Part part = solid_named("slotted_box").part;
    auto& wall = std::get<Plane>(part.faces[7].surface.form);
    wall.origin = wall.origin + Vec3{0, 1e-4, 0};
    EXPECT_NE(text_of(check_part(part, kTolerance)).find("off the surface"), std::string::npos);
    EXPECT_NEAR(part.miss_mm, 1e-4, 1e-9);
}

// The floor and the top of a slot have arcs at their ends. The centre of an arc is shifted by 0.5
// mm.
TEST(Check, FindsAnArcThatMissesItsEnd) {
    Part part = solid_named("slotted_box").part;
    for (Edge& edge : part.edges) {
        auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle) continue;
        circle->centre.y += 0.5;
        break;
    }
    EXPECT_NE(text_of(check_part(part, 1.0 / 16)).find("misses its end"), std::string::npos);
}

// Two circular holes of a floor touch in the origin, where neither circle has a vertex.
TEST(Check, FindsCirclesThatTouch) {
    Part part;
    const Vec3 up{0, 0, 1};
    Face floor;
    floor.surface.form = Plane{{}, up};
    const auto circle = [&](Vec3 centre, double radius, bool is_forward) {
        const auto v = static_cast<std::uint32_t>(part.vertices.size());
        // The vertex is neither at the contact nor half a sampling step of 3.75 degrees from there.
        const double cosine = std::cos(1.01), sine = std::sin(1.01);
        part.vertices.push_back(centre + radius * Vec3{cosine, sine, 0});
        floor.loops.push_back({{static_cast<std::uint32_t>(part.edges.size()), is_forward}});
        part.edges.push_back({v, v, Circle{centre, up, radius}});
    };
    circle({}, 50, true);
    circle({-8, 0, 0}, 8, false);
    circle({5, 0, 0}, 5, false);
    floor.frame = {{}, up, {1, 0, 0}};
    part.faces.push_back(floor);
    double miss = 0.0;
    EXPECT_EQ(faults_of(part, 0, 1e-9, miss).size(), 1U);
    std::get<Circle>(part.edges[2].curve).centre.x += 1e-5;
    part.vertices[2].x += 1e-5;
    EXPECT_EQ(faults_of(part, 0, 1e-9, miss).size(), 0U);
    EXPECT_EQ(faults_of(part, 0, 1e-9, miss, 1e-4).size(), 1U);
}

constexpr Vec3 kUp{0, 0, 1};

// Returns the faults of a level face that `loop` bounds.
std::string faults_between(std::vector<Vec3> corners, std::vector<Edge> edges, Loop loop) {
    Part part;
    part.vertices = std::move(corners);
    part.edges = std::move(edges);
    Face face;
    face.surface.form = Plane{{}, kUp};
    face.frame = {{}, kUp, {1, 0, 0}};
    face.loops = {std::move(loop)};
    part.faces.push_back(face);
    double miss = 0.0;
    return text_of(faults_of(part, 0, 1e-9, miss));
}

// A line through the axis of a pipe has no angle where it crosses the axis.
TEST(Check, FindsEdgesThatAreNowhereOnTheirSurface) {
    Part part;
    part.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    part.edges = {{0, 1, Line{}}, {1, 2, Line{}}, {2, 0, Line{}}};
    Face face;
    face.surface.form = Cylinder{{}, kUp, 1.0};
    face.frame = {{}, kUp, {0, -1, 0}};
    face.loops = {{{0, true}, {1, true}, {2, true}}};
    part.faces.push_back(face);
    double miss = 0.0;
    EXPECT_NE(text_of(faults_of(part, 0, 1e-3, miss)).find("nowhere"), std::string::npos);
}

// Two curves begin 2 µm from their common vertex, as edges next to facets do. Bisection brings the
// curves no nearer to the vertex.
TEST(Check, EndsWhereNeighboursMissTheirCorner) {
    Part part;
    part.vertices = {{-1.93e-3, -5.3e-4, 0}, {10, 0, 0}};
    part.edges = {{0, 1, Spline{{{0, 0, 0}, {2, 0.5, 0}, {8, 0.5, 0}, {10, 0, 0}}, {0, 1}}},
                  {1, 0, Spline{{{10, 0, 0}, {8, 0.6, 0}, {2, 0.6, 0}, {0, 0, 0}}, {0, 1}}}};
    Face face;
    face.surface.form = Plane{{}, kUp};
    face.frame = {{}, kUp, {1, 0, 0}};
    face.loops = {{{0, true}, {1, true}}};
    part.faces.push_back(face);
    double miss = 0.0;
    EXPECT_EQ(text_of(faults_of(part, 0, 1e-2, miss)), "");
}

// A line ends at the tip of a slender ellipse. A rising line crosses the ellipse a second time:
// 0.04 mm before the tip (a fault), or so near the tip that the curves may be meant to touch
// (accepted).
TEST(Check, FindsNeighboursThatCrossNearTheirCorner) {
    const auto faults = [](double rise) {
        return faults_between(
            {{0, 0, 0}, {-1, 10, 0}, {-9.95, 9.95 * rise, 0}},
            {{1, 0, Ellipse{{0, 10, 0}, kUp, {0, 1, 0}, 10, 1}}, {1, 2, Line{}}, {2, 0, Line{}}},
            {{2, true}, {0, false}, {1, true}});
    };
    EXPECT_NE(faults(0.2).find(kCrossOrTouch), std::string::npos);
    EXPECT_EQ(faults(0.001), "");
    EXPECT_EQ(faults(-0.2), "");
}

// The vertex at the end of two arcs lies beyond the contact that follows from the radii 5 and 15 mm
// and from the distance of the centres. So the arcs cross a second time before the vertex: by 0.2
// mm, by 0.02 mm (readers see this as well), or by rounding only (accepted).
TEST(Check, FindsNeighboursThatCrossBeforeTheirCorner) {
    const auto faults = [](double half) {
        // Both circles pass through (`half`, 0) and (-`half`, 0).
        const double inner = std::sqrt(25.0 - half * half), outer = std::sqrt(225.0 - half * half);
        const Vec3 low{0, -inner, 0}, lower{0, -outer, 0};
        const auto on = [](Vec3 centre, double radius, double degrees) {
            const double a = degrees * 3.14159265358979323846 / 180.0;
            return centre + radius * Vec3{std::cos(a), std::sin(a), 0};
        };
        return faults_between(
            {{-half, 0, 0}, on(low, 5, 30), on(lower, 15, 60)},
            {{1, 0, Circle{low, kUp, 5}}, {0, 2, Circle{lower, -kUp, 15}}, {2, 1, Line{}}},
            {{0, false}, {2, false}, {1, false}});
    };
    EXPECT_NE(faults(0.1).find(kCrossOrTouch), std::string::npos);
    EXPECT_NE(faults(0.01).find(kCrossOrTouch), std::string::npos);
    EXPECT_EQ(faults(1e-7), "");
}

// Returns the faults of a slot's floor along an arc of radius `path`, cut by a tool of radius
// `tool`, that ends at the circle of a plunge. The outer arc and the circle are tangent at their
// common vertex if `miss`, the offset of the circle's centre, is 0.
std::string faults_beside_plunge(double miss, double path = 7.2, double tool = 3.0) {
    const double out = path + tool, in = path - tool;
    const Circle outside{{}, kUp, out}, inside{{}, kUp, in};
    const Circle plunge{{path + miss, 0, 0}, -kUp, tool}, start{{-path, 0, 0}, -kUp, tool};
    return faults_between({{-out, 0, 0}, {out, 0, 0}, {in, 0, 0}, {-in, 0, 0}},
                          {{0, 1, outside}, {1, 2, plunge}, {3, 2, inside}, {0, 3, start}},
                          {{0, true}, {1, true}, {2, false}, {3, false}});
}

TEST(Check, FindsArcsThatRunOutTogetherAndCross) {
    EXPECT_EQ(faults_beside_plunge(0.0), "");
    for (const double miss : {1e-9, 1e-8, 1e-7})
        EXPECT_NE(faults_beside_plunge(miss).find(kCrossOrTouch), std::string::npos) << miss;
}

// The chords of a small and a large arc that are tangent lie on each other at some of these ratios.
TEST(Check, LetsSmallArcsRunOutTogether) {
    for (const double tool : {0.05, 0.15, 0.3048, 0.4, 1.5}) {
        for (int k = 0; k < 200; ++k) {
            const double path = tool * (1.1 + 0.05 * k);
            EXPECT_EQ(faults_beside_plunge(0.0, path, tool), "") << tool << " on " << path;
        }
    }
}

// Edges of facets lie off the adjacent cone. If two such edges meet near the apex, it is
// undecidable whether the apex belongs to the face.
TEST(Check, FindsEdgesBesideTheApexOfACone) {
    const auto faults = [](Vec3 near_tip) {
        Part part;
        const Vec3 up{0, 0, 1};
        part.vertices = {{-1, 1, std::sqrt(2.0)}, near_tip, {1, 1, std::sqrt(2.0)}};
        part.edges = {{0, 1, Line{}},
                      {1, 2, Line{}},
                      {2, 0, Circle{{0, 0, std::sqrt(2.0)}, up, std::sqrt(2.0)}}};
        Face face;
        face.surface = {Cone{{}, up, 1.0}, true};
        face.frame = {{0, 0, 1}, up, {0, -1, 0}};
        face.loops = {{{2, false}, {1, false}, {0, false}}};
        part.faces.push_back(face);
        double miss = 0.0;
        return text_of(faults_of(part, 0, 0.1, miss));
    };
    EXPECT_NE(faults({0, -2e-4, 0.013}).find("misses the apex"), std::string::npos);
    // On the cone, on the side opposite to the edges' ends.
    EXPECT_NE(faults({0, -0.02, 0.02}).find("misses the apex"), std::string::npos);
    EXPECT_EQ(faults({0, 0, 0}).find("misses the apex"), std::string::npos);
    EXPECT_EQ(faults({0, 0.5, 0.5}).find("misses the apex"), std::string::npos);
}

// The wall of a bore without its lower loop, then a torus with a single loop.
TEST(Check, FindsFacesWithoutAnOtherEnd) {
    Part part = solid_named("bored_box").part;
    const auto wall = std::ranges::find_if(part.faces, [](const Face& face) {
        return std::holds_alternative<Cylinder>(face.surface.form);
    });
    ASSERT_NE(wall, part.faces.end());
    const auto number = static_cast<std::uint32_t>(wall - part.faces.begin());
    double miss = 0.0;
    EXPECT_EQ(text_of(faults_of(part, number, kTolerance, miss)), "");
    const Cylinder bore = std::get<Cylinder>(wall->surface.form);
    wall->loops.pop_back();
    EXPECT_NE(text_of(faults_of(part, number, kTolerance, miss)).find("at one end only"),
              std::string::npos);
    wall->surface.form = Torus{bore.origin, bore.axis, bore.radius - 1.0, 1.0};
    EXPECT_NE(text_of(faults_of(part, number, 10.0, miss)).find("at one end only"),
              std::string::npos);
}

TEST(Check, FindsLoopsThatCross) {
    Part part = solid_named("bored_box").part;
    for (Edge& edge : part.edges) {
        auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle) continue;
        // Moves the bore beyond the side of the box.
        circle->centre.x += 9;
        part.vertices[edge.from].x += 9;
    }
    for (Face& face : part.faces) {
        if (auto* bore = std::get_if<Cylinder>(&face.surface.form)) bore->origin.x += 9;
    }
    EXPECT_NE(text_of(check_part(part, kTolerance)).find("cross or touch"), std::string::npos);
}

TEST(Check, FindsTheLongWayRound) {
    Part part = solid_named("slotted_box").part;
    for (Edge& edge : part.edges) {
        auto* circle = std::get_if<Circle>(&edge.curve);
        if (circle) circle->axis = -circle->axis;
    }
    EXPECT_NE(text_of(check_part(part, kTolerance)), "");
}

// Returns walls and lids of a post with the given corners, 5 mm high.
Part post(const std::vector<std::pair<double, double>>& corners) {
    cda::Boundary walls;
    for (const double z : {0.0, 5.0}) {
        for (const auto& [x, y] : corners)
            walls.vertices.push_back({x, y, z});
    }
    walls.shells = 1;
    const auto n = static_cast<std::uint32_t>(corners.size());
    cda::BoundaryFace top{{0, 0, 1}, 5.0, cda::kStockOrigin, 0, {{}}}, bottom = top;
    bottom.normal = {0, 0, -1};
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        const Vec3 along = walls.vertices[j] - walls.vertices[i];
        walls.faces.push_back({normalized(cross(along, {0, 0, 1})),
                               0.0,
                               cda::kStockOrigin,
                               0,
                               {{i, j, j + n, i + n}}});
        top.loops[0].push_back(i + n);
        bottom.loops[0].insert(bottom.loops[0].begin(), i);
    }
    walls.faces.push_back(top);
    walls.faces.push_back(bottom);
    return faceted(walls,
                   std::vector<std::vector<cda::Origin>>(walls.faces.size(), {cda::kStockOrigin}));
}

double shortest_edge(const Part& part) {
    double shortest = 1e9;
    for (const Face& face : part.faces) {
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const Edge& edge = part.edges[use.edge];
                shortest =
                    std::min(shortest, norm(part.vertices[edge.to] - part.vertices[edge.from]));
            }
        }
    }
    return shortest;
}

// Two of the five corners are 1.4e-8 mm apart. Readers merge both and find the walls open.
TEST(Apart, MakesOneOfCornersThatReadersWouldTakeForOne) {
    const double near = 1e-8;
    Part part = post({{0, 0}, {10, 0}, {10, 10 - near}, {10 - near, 10}, {0, 10}});
    enforce_min_vertex_distance(part);
    EXPECT_EQ(part.faces.size(), 6U);
    EXPECT_GT(shortest_edge(part), 4.9);
    EXPECT_EQ(text_of(check_part(part, 1e-4)), "");
}

// Moves the plane of a wall of post() outwards. The corners of the wall are off the plane then.
void move_wall(Part& part, std::size_t wall, double by_mm) {
    Plane& plane = std::get<Plane>(part.faces[wall].surface.form);
    plane.origin = plane.origin + by_mm * plane.normal;
}

// The corners of a wall are off its plane by 5e-5 mm. The adjacent planes determine where they are.
TEST(Apart, MovesCornersOntoTheirPlanes) {
    Part part = post({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    move_wall(part, 0, 5e-5);
    enforce_min_vertex_distance(part);
    for (const Face& face : part.faces) {
        for (const EdgeUse& use : face.loops.front()) {
            for (const std::uint32_t v : {part.edges[use.edge].from, part.edges[use.edge].to})
                EXPECT_NEAR(distance(face.surface.form, part.vertices[v]), 0.0, 1e-9);
        }
    }
    EXPECT_NEAR(volume(part), 5 * 10 * (10 + 5e-5), 1e-9);
}

// Returns a post with a wall of 4e-5 mm between two walls at 3 degrees to it (walls 2 and 4).
Part post_with_short_edge() {
    return post({{0, 0}, {10, 0}, {10, 10}, {5 + 4e-5, 10.25}, {5, 10.25}, {0, 10}});
}

// The planes of both walls are 2.5e-5 mm off the ends of the edge. Readers give both ends this
// width, and lose the edge between them.
TEST(Apart, EdgesShorterThanTheirEndsAreWideArePoints) {
    Part part = post_with_short_edge();
    move_wall(part, 2, 2.5e-5);
    move_wall(part, 4, 2.5e-5);
    enforce_min_vertex_distance(part);
    EXPECT_EQ(part.faces.size(), 7U);
    EXPECT_GT(shortest_edge(part), 4.9);
    EXPECT_EQ(text_of(check_part(part, 1e-4)), "");
}

TEST(Apart, EdgesOfCornersWithoutWidthStay) {
    Part part = post_with_short_edge();
    enforce_min_vertex_distance(part);
    EXPECT_EQ(part.faces.size(), 8U);
    EXPECT_NEAR(shortest_edge(part), 4e-5, 1e-9);
}

// A spur of 1e-7 mm at 3 degrees to a wall. A longer spur would be nearer to the wall than readers
// can resolve.
TEST(Apart, MakesNoSpursOfCorners) {
    const double near = 1e-7;
    Part part = post({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {near, 10 - 0.05 * near}});
    enforce_min_vertex_distance(part);
    EXPECT_EQ(part.faces.size(), 6U);
    EXPECT_EQ(text_of(check_part(part, 1e-4)), "");
}

// The lid of a post extends as a line of zero width into a wall, which has a hole of two edges
// there.
TEST(Apart, TakesOutWhatHasNoWidth) {
    Part part = post({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const auto tip = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back({5, 0, 2});
    Loop& lid = part.faces[4].loops.front();
    const EdgeUse first = lid.front();
    const std::uint32_t corner =
        first.is_forward ? part.edges[first.edge].from : part.edges[first.edge].to;
    const auto there = static_cast<std::uint32_t>(part.edges.size());
    part.edges.push_back({corner, tip, Line{}});
    part.edges.push_back({tip, corner, Line{}});
    lid.insert(lid.begin(), {{there, true}, {there + 1, true}});
    part.faces[0].loops.push_back({{there + 1, false}, {there, false}});
    EXPECT_NE(text_of(check_part(part, 10.0)), "");
    enforce_min_vertex_distance(part);
    EXPECT_EQ(text_of(check_part(part, 1e-9)), "");
    EXPECT_EQ(part.faces.size(), 6U);
}

// The lid contains a second face between a side of the lid and two short edges. Both faces have an
// edge of their own along that side, with no area of the lid in between.
TEST(Apart, ClosesSlitsBetweenAnOutlineAndAHole) {
    Part part = post({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const EdgeUse side = part.faces[4].loops.front().front();
    const auto ends = std::pair(part.edges[side.edge].from, part.edges[side.edge].to);
    const auto [from, to] = side.is_forward ? ends : std::pair(ends.second, ends.first);
    const auto tip = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back({5, 3, 5});
    const auto first = static_cast<std::uint32_t>(part.edges.size());
    part.edges.insert(part.edges.end(),
                      {{from, to, Line{}}, {to, tip, Line{}}, {tip, from, Line{}}});
    Face within = part.faces[4];
    within.loops = {{{first, true}, {first + 1, true}, {first + 2, true}}};
    part.faces[4].loops.push_back({{first, false}, {first + 2, false}, {first + 1, false}});
    part.solids.front().outside.push_back(static_cast<std::uint32_t>(part.faces.size()));
    part.faces.push_back(within);
    EXPECT_NE(text_of(check_part(part, 1e-4)), "");
    enforce_min_vertex_distance(part);
    EXPECT_EQ(text_of(check_part(part, 1e-4)), "");
    EXPECT_EQ(part.faces.size(), 7U);
    EXPECT_EQ(part.faces[4].loops.size(), 1U);
    EXPECT_EQ(part.faces[4].loops.front().size(), 5U);
    EXPECT_NEAR(volume(part), 500.0, 1e-9);
}

std::string faults_of_solids(Part& part) {
    for (const Solid& solid : part.solids)
        EXPECT_EQ(solid.outside.size(), part.faces.size());
    return text_of(check_part(part, 1e-4));
}

// A corner of the lid is in the middle of the opposite edge, up to rounding. The lid becomes two
// triangles that meet in that corner.
TEST(Apart, PartsFacesWithACornerOnTheirEdge) {
    Part part = post({{0, 0}, {10, 0}, {10, 10}, {5, 1e-8}, {0, 10}});
    EXPECT_NE(text_of(check_part(part, 1e-4)).find(kCrossOrTouch), std::string::npos);
    const std::vector<std::uint32_t> was = enforce_min_vertex_distance(part);
    EXPECT_EQ(faults_of_solids(part), "");
    EXPECT_EQ(part.faces.size(), 9U);
    EXPECT_EQ(was, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 5, 6}));
    EXPECT_NEAR(volume(part), 250.0, 1e-5);
}

// A corner of the lid is 2e-5 mm from the opposite edge, to which readers give a width of 2.5e-5
// mm.
TEST(Apart, PartsFacesWithACornerWithinTheWidthOfAnEdge) {
    const std::vector<std::pair<double, double>> outline{{-10, 0.2}, {0, 0},    {10, 0},  {20, 0.2},
                                                         {20, 10},   {5, 2e-5}, {-10, 10}};
    Part part = post(outline);
    move_wall(part, 1, 2.5e-5);
    enforce_min_vertex_distance(part);
    EXPECT_EQ(faults_of_solids(part), "");
    EXPECT_EQ(part.faces.size(), 11U);
    Part exact = post(outline);
    enforce_min_vertex_distance(exact);
    EXPECT_EQ(exact.faces.size(), 9U);
}

// Two corners of the lid coincide up to rounding. The lid becomes two faces that meet there.
TEST(Apart, PartsFacesWithTwoCornersInOnePlace) {
    Part part = post({{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5 + 1e-8}});
    EXPECT_NE(text_of(check_part(part, 1e-4)).find(kCrossOrTouch), std::string::npos);
    enforce_min_vertex_distance(part);
    EXPECT_EQ(faults_of_solids(part), "");
    EXPECT_EQ(part.faces.size(), 10U);
    EXPECT_NEAR(volume(part), 250.0, 1e-5);
}

// A side of the lid goes up, slightly back along itself, and on. The fold is as wide as simplified
// polyhedra may have folds.
TEST(Apart, TakesOutFoldsThatReadersCannotSee) {
    for (const double width : {1e-6, 1e-5}) {
        SCOPED_TRACE(width);
        Part part =
            post({{0, 0}, {10, 0}, {10, 10}, {2 * width, 10}, {-6 * width, 8}, {-2 * width, 10}});
        EXPECT_NE(text_of(check_part(part, 1e-4)).find(kCrossOrTouch), std::string::npos);
        enforce_min_vertex_distance(part);
        EXPECT_EQ(faults_of_solids(part), "");
        EXPECT_NEAR(volume(part), 500.0, 1e-2);
    }
}

// A pit in the side of a block is 4e-7 mm wide. Readers cannot separate its two corners, which the
// top, the side and the end of the pit share.
TEST(Apart, ClosesPitsTooNarrowForReaders) {
    cda::Boundary block;
    block.vertices = {{0, 0, 0},  {10, 0, 0},        {10, 10, 0}, {0, 10, 0},
                      {0, 0, 5},  {10, 0, 5},        {10, 10, 5}, {0, 10, 5},
                      {5, 10, 5}, {5 + 4e-7, 10, 5}, {5, 7, 5},   {5, 8, 3}};
    block.shells = 1;
    const std::vector<std::vector<std::uint32_t>> corners{
        {3, 2, 1, 0},       {4, 5, 6, 9, 10, 8, 7}, {0, 1, 5, 4}, {1, 2, 6, 5},
        {2, 3, 7, 8, 9, 6}, {3, 0, 4, 7},           {9, 8, 11},   {10, 9, 11},
        {8, 10, 11}};
    for (const auto& loop : corners) {
        const Vec3 a = block.vertices[loop[0]], b = block.vertices[loop[1]];
        const Vec3 c = block.vertices[loop[2]];
        block.faces.push_back({normalized(cross(b - a, c - a)), 0.0, cda::kStockOrigin, 0, {loop}});
    }
    Part part = faceted(block, std::vector<std::vector<cda::Origin>>(9, {cda::kStockOrigin}));
    EXPECT_NE(text_of(check_part(part, 1e-4)), "");
    enforce_min_vertex_distance(part);
    EXPECT_EQ(faults_of_solids(part), "");
    EXPECT_EQ(part.faces.size(), 6U);
    EXPECT_NEAR(volume(part), 500.0, 1e-5);
}

// Both ends of a short edge have a common neighbour that is on no face adjacent to the edge.
// Merging the ends would make two edges to that neighbour.
TEST(Apart, KeepsCornersThatHoldTheSurfaceTogether) {
    cda::Boundary two;
    two.vertices = {{0, 0, 5}, {0, 0, -5}, {5, 0, 0}, {-5, -5e-8, 0}, {-5, 5e-8, 0}};
    two.shells = 1;
    const std::vector<std::vector<std::uint32_t>> corners{{0, 3, 2}, {0, 2, 4}, {0, 4, 3},
                                                          {1, 2, 3}, {1, 4, 2}, {1, 3, 4}};
    for (const auto& loop : corners) {
        const Vec3 a = two.vertices[loop[0]], b = two.vertices[loop[1]], c = two.vertices[loop[2]];
        two.faces.push_back({normalized(cross(b - a, c - a)), 0.0, cda::kStockOrigin, 0, {loop}});
    }
    Part part = faceted(two, std::vector<std::vector<cda::Origin>>(6, {cda::kStockOrigin}));
    enforce_min_vertex_distance(part);
    EXPECT_EQ(part.faces.size(), 6U);
    EXPECT_GT(shortest_edge(part), 9e-6);
}

}  // namespace
}  // namespace ncsim::brep
