// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the triangulation of faces with degenerate outlines.
#include "ncsim/cda/triangulate.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ncsim::cda {
namespace {

using Loop = std::vector<std::uint32_t>;

// A plate without thickness: a face seen from above, and the same face seen from below.
struct Plate {
    Boundary boundary;

    explicit Plate(const std::vector<std::vector<Vec3>>& loops) {
        BoundaryFace above{{0, 0, 1}, 0.0, kStockOrigin, 0, {}};
        BoundaryFace below{{0, 0, -1}, 0.0, kStockOrigin, 0, {}};
        for (const auto& points : loops) {
            Loop loop;
            for (const Vec3 p : points) {
                loop.push_back(static_cast<std::uint32_t>(boundary.vertices.size()));
                boundary.vertices.push_back(p);
            }
            above.loops.push_back(loop);
            std::reverse(loop.begin(), loop.end());
            below.loops.push_back(loop);
        }
        boundary.faces = {above, below};
        boundary.shells = 1;
    }
};

// Returns the area of all triangles of the upper face, regardless of their orientation.
double total_area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (mesh.face[t] != 0) continue;
        sum += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a],
                                mesh.vertices[c] - mesh.vertices[a]));
    }
    return sum;
}

void expect_area(const std::vector<std::vector<Vec3>>& loops, double area) {
    const Plate plate(loops);
    const TriangleMesh mesh = triangulate(plate.boundary);
    EXPECT_TRUE(check(mesh).is_closed());
    EXPECT_NEAR(total_area(mesh), area, 1e-12);
    ASSERT_GE(mesh.vertices.size(), plate.boundary.vertices.size());
    for (std::size_t v = 0; v < plate.boundary.vertices.size(); ++v)
        EXPECT_EQ(mesh.vertices[v], plate.boundary.vertices[v]);
}

TEST(Triangulate, ACornerOnAnEdge) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 0, 0}, {0, 3, 0}}}, 6.0);
}

TEST(Triangulate, ACornerBeyondAnEdgeByRounding) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, -1e-15, 0}, {0, 3, 0}}}, 6.0);
}

TEST(Triangulate, TwoCornersInOnePlace) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 0}}}, 8.0);
}

TEST(Triangulate, AllCornersOnOneLine) {
    expect_area({{{0, 0, 0}, {3, 0, 0}, {4, 0, 0}, {1, 0, 0}}}, 0.0);
    expect_area({{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, 0.0);
}

TEST(Triangulate, AHoleThatLiesUponTheOutline) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                 {{1, 0, 0}, {1, 2, 0}, {3, 2, 0}, {3, 0, 0}}},
                12.0);
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{2, 0, 0}, {1, 2, 0}, {3, 2, 0}}},
                14.0);
}

TEST(Triangulate, AFaceThatWindsAroundAPlaceTwice) {
    expect_area(
        {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}},
        20.0);
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, 1, 0}, {3, 1, 0}, {1, 2, 0}}}, 9.5);
}

// Simplification may leave this outline if it may move corners by as much as a hole is wide.
TEST(Triangulate, AHoleThatTurnsTheWrongWay) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}},
                16.5);
}

// Taken from a five-axis program: the crossing of two edges lies on a third edge.
TEST(Triangulate, ACrossingOnAThirdEdge) {
    // The projection drops x, because the normal is longest there.
    const Vec3 n{-0.89628945577962593, 0.43560303412979123, 0.083157730339289179};
    const double offset = 22.620627775432126;
    Boundary boundary;
    boundary.vertices = {{-25.483576279202104, 0.42304812627077104, -4.8620132477056979},
                         {-25.387071673008204, 0.72133552197277551, -5.3843800014328957},
                         {-25.526986760191321, 0.28891055215299127, -4.6272500114363435},
                         {-25.358237981469035, 0.80968895879328251, -5.536424692958593},
                         {-25.357221780608892, 0.81632875796437265, -5.5602529833722114},
                         {-25.125029927526711, 1.1159701631963252, -4.6272500737327338},
                         {-25.12503002723038, 1.1159699386835098, -4.6272499722975491},
                         {-25.125028776515126, 1.1159779683583975, -4.6272785535013679},
                         {-25.409536605448722, 0.53057400735557081, -4.6272500000000001},
                         {-25.125029999999999, 1.1159699999999999, -4.6272500000000001},
                         {-25.419829523104429, 0.50939547378718852, -4.6272500010025501},
                         {-25.387071678025723, 0.72133551332950596, -5.3843800102370976}};
    Loop loop{2, 10, 9, 8, 6, 5, 7, 4, 3, 11, 1, 0};
    boundary.faces.push_back({n, offset, kStockOrigin, 0, {loop}});
    std::reverse(loop.begin(), loop.end());
    boundary.faces.push_back({-n, -offset, kStockOrigin, 0, {loop}});
    const TriangleMesh mesh = triangulate(boundary);
    EXPECT_TRUE(check(mesh).is_closed());
    Vec3 sum;
    const Vec3 apex = boundary.vertices[0];
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum = sum + 0.5 * cross(boundary.vertices[loop[(i + 1) % loop.size()]] - apex,
                                boundary.vertices[loop[i]] - apex);
    EXPECT_NEAR(total_area(mesh), norm(sum), 1e-6);
}

// Taken from a program with arcs in ZX: a face as thin as the rounding of its corners. The area
// between edges and their chains consists of pairs of opposite triangles with all three edges in
// common.
TEST(Triangulate, TrianglesThereAndBack) {
    const Vec3 n{0.25342853606597437, 0.9516499203738541, 0.17359840483107628};
    const double offset = -21.009501746713184;
    Boundary boundary;
    boundary.vertices = {{-16.067070095386505, -19.701219995544552, 10.432219974714517},
                         {-16.067070095196961, -19.701219994106889, 10.432219966557621},
                         {-17.05331, -19.438580000000002, 10.432219999999999},
                         {-17.05331001876533, -19.438579995003341, 10.432219999999999},
                         {-17.053310201728344, -19.438579941019416, 10.432219971166253},
                         {-17.0533102007401, -19.438579938634636, 10.432219956649542}};
    Loop loop{4, 3, 0, 1, 2, 5};
    boundary.faces.push_back({n, offset, kStockOrigin, 0, {loop}});
    std::reverse(loop.begin(), loop.end());
    boundary.faces.push_back({-n, -offset, kStockOrigin, 0, {loop}});
    const TriangleMesh mesh = triangulate(boundary);
    EXPECT_TRUE(check(mesh).is_closed());
    EXPECT_LE(total_area(mesh), 1e-7);
}

// Cutters leave a band along a path of short moves that is narrower than the rounding of its
// coordinates. The band's edges cross many times, and no triangle may bridge a bend.
TEST(Triangulate, NarrowBandsStayNarrow) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(-3.0, 3.0);
    for (int trial = 0; trial < 200; ++trial) {
        const double width = std::pow(10.0, -16 + trial % 10);
        std::vector<Vec3> there;
        std::vector<Vec3> back;
        Vec3 at{1000.0, 1000.0, 0.0};
        for (int i = 0; i < 12; ++i) {
            there.push_back(at);
            back.push_back({at.x, at.y + width * (4.0 + step(random)), 0.0});
            at = at + Vec3{2.0 + step(random) / 3.0, step(random), 0.0};
        }
        std::reverse(back.begin(), back.end());
        there.insert(there.end(), back.begin(), back.end());
        const TriangleMesh mesh = triangulate(Plate({there}).boundary);
        EXPECT_TRUE(check(mesh).is_closed()) << "trial " << trial;
        EXPECT_LE(total_area(mesh), 40.0 * (10.0 * width + 1e-12)) << "trial " << trial;
    }
}

// Corners on an ellipse, and some in between: no circumcircle of a triangle contains a further
// corner.
TEST(Triangulate, ConvexFacesAreDelaunay) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<double> angles(3 + static_cast<std::size_t>(trial % 12));
        for (double& angle : angles)
            angle = 6.283 * unit(random);
        std::sort(angles.begin(), angles.end());
        std::vector<Vec3> corners;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const auto at = [&](double t) { return Vec3{5 * std::cos(t), 2 * std::sin(t), 0.0}; };
            const Vec3 here = at(angles[i]);
            const Vec3 next = at(angles[(i + 1) % angles.size()]);
            corners.push_back(here);
            if (i % 3 == 1) corners.push_back(0.5 * (here + next));
        }
        Plate plate({corners});
        plate.boundary.faces.resize(1);  // both faces would have the same diagonals
        const TriangleMesh mesh = triangulate(plate.boundary);
        ASSERT_EQ(mesh.triangles.size(), corners.size() - 2);
        for (const auto& [a, b, c] : mesh.triangles) {
            EXPECT_GT(
                cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]).z,
                0.0);
            for (const Vec3& d : corners) {
                const auto row = [&](std::uint32_t v) {
                    const Vec3 off = mesh.vertices[v] - d;
                    return Vec3{off.x, off.y, dot(off, off)};
                };
                // Positive if d is in the circle through a, b and c.
                EXPECT_LE(dot(row(a), cross(row(b), row(c))), 1e-9) << "trial " << trial;
            }
        }
    }
}

// Faces of all kinds, in several tasks. Some faces get new vertices, which are numbered in order.
TEST(Triangulate, DoesNotDependOnTheNumberOfThreads) {
    Boundary all;
    const auto add = [&](const std::vector<std::vector<Vec3>>& loops, double at) {
        const Plate plate(loops);
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (const Vec3& p : plate.boundary.vertices)
            all.vertices.push_back(p + Vec3{at, 0, 0});
        for (BoundaryFace face : plate.boundary.faces) {
            for (Loop& loop : face.loops) {
                for (std::uint32_t& v : loop)
                    v += first;
            }
            all.faces.push_back(face);
        }
    };
    for (int i = 0; i < 600; ++i) {
        const double at = 10.0 * i;
        add({{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}}, at);
        add({{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 3, 0}}}, at);
        if (i % 50 == 7) add({{{0, 0, 0}, {4, 3, 0}, {4, 0, 0}, {0, 3, 0}}}, at);  // crosses itself
    }
    const TriangleMesh one = triangulate(all, 1);
    EXPECT_GT(one.vertices.size(), all.vertices.size());
    EXPECT_TRUE(std::is_sorted(one.face.begin(), one.face.begin() + 2000));
    for (const std::size_t threads : {2U, 5U}) {
        const TriangleMesh other = triangulate(all, threads);
        EXPECT_EQ(other.vertices, one.vertices);
        EXPECT_EQ(other.triangles, one.triangles);
        EXPECT_EQ(other.face, one.face);
    }
}

}  // namespace
}  // namespace ncsim::cda
