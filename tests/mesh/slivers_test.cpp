// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the removal of needles, caps and tiny shells from meshes.
#include "slivers.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/triangulate.h"

#include "support/cube.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace ncsim::mesh {
namespace {

using ncsim::test::cube;

// Returns the number of triangles lower than `least`.
std::size_t low(const TriangleMesh& mesh, double least) {
    return static_cast<std::size_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
            const Vec3 ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
            const Vec3 ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
            const Vec3 bc = mesh.vertices[t[2]] - mesh.vertices[t[1]];
            const double longest = std::max({norm(ab), norm(ac), norm(bc)});
            return norm(cross(ab, ac)) < least * longest;
        }));
}

TEST(Slivers, ACapIsCutIntoItsNeighbour) {
    TriangleMesh mesh = cube();
    // Vertex 8 is next to the edge between the top and the first side, on the side.
    mesh.vertices.push_back({0.4, 0.0, 1.0 - 1e-6});
    mesh.triangles[5] = {0, 5, 8};
    mesh.triangles.push_back({0, 8, 4});
    mesh.triangles.push_back({8, 5, 4});
    mesh.face.insert(mesh.face.end(), {2, 2});
    ASSERT_TRUE(cda::check(mesh).is_closed());
    ASSERT_EQ(low(mesh, 1e-5), 1U);
    remove_slivers(mesh, 1e-5);
    EXPECT_TRUE(cda::check(mesh).is_closed());
    EXPECT_EQ(low(mesh, 0.1), 0U);
    EXPECT_EQ(mesh.triangles.size(), 14U);
    EXPECT_EQ(std::count(mesh.face.begin(), mesh.face.end(), 1U), 3) << "the top has one more";
    EXPECT_NEAR(cda::volume(mesh), 1.0, 1e-6);
}

TEST(Slivers, ANeedleBecomesAnEdgeAndCornersOfThePartStay) {
    TriangleMesh mesh = cube();
    // Next to the corner 5, on the edge to 4.
    mesh.vertices.push_back({1.0 - 1e-6, 0.0, 1.0});
    mesh.triangles[2] = {4, 8, 6};
    mesh.triangles.push_back({8, 5, 6});
    mesh.triangles[5] = {0, 8, 4};
    mesh.triangles.push_back({0, 5, 8});
    mesh.face.insert(mesh.face.end(), {1, 2});
    ASSERT_TRUE(cda::check(mesh).is_closed());
    remove_slivers(mesh, 1e-5);
    EXPECT_TRUE(cda::check(mesh).is_closed());
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_DOUBLE_EQ(cda::volume(mesh), 1.0) << "the corner is where it was";
}

TEST(Slivers, NothingHappensWithoutATolerance) {
    TriangleMesh mesh = cda::triangulate(test::polytope_part().boundary());
    const TriangleMesh before = mesh;
    remove_slivers(mesh, 0.0);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

// Two boxes, the second thinner than the tolerance.
TEST(Slivers, AShellSmallerThanTheToleranceVanishes) {
    TriangleMesh mesh = cube();
    const TriangleMesh small = cube();
    for (const Vec3 v : small.vertices)
        mesh.vertices.push_back(Vec3{5, 5, 5} + 1e-7 * v);
    for (auto triangle : small.triangles) {
        for (auto& v : triangle)
            v += 8;
        mesh.triangles.push_back(triangle);
        mesh.face.push_back(6);
    }
    remove_slivers(mesh, 1e-5);
    EXPECT_TRUE(cda::check(mesh).is_closed());
    EXPECT_EQ(mesh.triangles, cube().triangles);
}

// Some slivers stay, because they connect the wedges and fins of a thin wall.
TEST(Slivers, FewAreLeftOfAPartThatIsFullOfThem) {
    for (const double least : {0.01, 0.04}) {
        TriangleMesh mesh = cda::triangulate(test::polytope_part().boundary());
        const double volume = cda::volume(mesh);
        const std::size_t before = low(mesh, least);
        ASSERT_GE(before, 10U) << "else there is nothing to see";
        remove_slivers(mesh, least);
        EXPECT_TRUE(cda::check(mesh).is_closed()) << least;
        EXPECT_LE(low(mesh, least), before / 5) << least;
        EXPECT_NEAR(cda::volume(mesh), volume, 1e-3 * volume) << least;
    }
}

}  // namespace
}  // namespace ncsim::mesh
