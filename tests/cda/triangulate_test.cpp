// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/check.h"
#include "ncsim/cda/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ncsim::cda {
namespace {

using Loop = std::vector<std::uint32_t>;

// A plate without thickness: a face seen from above, and the same from below.
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

// Of all triangles of the face above, whichever way they turn.
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

// As simplification may leave it, where it is allowed to move corners by as much as a hole is wide.
TEST(Triangulate, AHoleThatTurnsTheWrongWay) {
    expect_area({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}},
                16.5);
}

// What cutters leave beside a path of short moves: a band narrower than the rounding of
// its coordinates. Its edges cross many times, and no triangle may bridge its bends.
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

}  // namespace
}  // namespace ncsim::cda
