// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests that meshes stay closed when coordinates are rounded to floats.
#include "ncsim/mesh/float_mesh.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/export/stl.h"

#include "support/cube.h"
#include "support/polytope_part.h"
#include "support/random_shapes.h"
#include "support/written_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ncsim::mesh {
namespace {

using ncsim::test::cube;
using ncsim::test::Soundness;

TriangleMesh placed(TriangleMesh mesh, double scale, Vec3 shift) {
    for (Vec3& v : mesh.vertices)
        v = scale * v + shift;
    return mesh;
}

// Returns both meshes. `same` lists vertices of `b` with the vertices of `a` that replace them.
TriangleMesh united(TriangleMesh a, const TriangleMesh& b,
                    const std::vector<std::array<std::uint32_t, 2>>& same = {}) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (auto triangle : b.triangles) {
        for (std::uint32_t& v : triangle) {
            const auto found = std::find_if(same.begin(), same.end(),
                                            [&](const auto& pair) { return pair[0] == v; });
            v = found != same.end() ? (*found)[1] : v + first;
        }
        a.triangles.push_back(triangle);
    }
    const std::uint32_t faces = a.face.empty() ? 0 : a.face.back() + 1;
    for (const std::uint32_t face : b.face)
        a.face.push_back(face + faces);
    return a;
}

Soundness written(const TriangleMesh& mesh) {
    std::ostringstream out;
    exporter::write_stl(out, mesh);
    return ncsim::test::soundness(ncsim::test::read_stl(out.str()));
}

// Returns the distance between floats just below the largest coordinate.
double step_of(const TriangleMesh& mesh) {
    double largest = 0.0;
    for (const Vec3& v : mesh.vertices)
        largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return std::ldexp(1.0, std::ilogb(largest) - 23);
}

// Returns how many steps a corner is at most from the float nearest to its exact place.
int farthest_moved(const TriangleMesh& mesh) {
    const FloatMesh rounded = round_to_floats(mesh);
    const double step = step_of(mesh);
    double farthest = 0.0;
    for (const auto& triangle : rounded.triangles) {
        for (const std::uint32_t v : triangle) {
            const FloatPoint nearest = to_floats(mesh.vertices[rounded.vertex[v]]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                farthest =
                    std::max(farthest, std::abs(static_cast<double>(nearest[axis]) -
                                                static_cast<double>(rounded.points[v][axis])));
            }
        }
    }
    return static_cast<int>(std::ceil(farthest / step - 1e-3));
}

TEST(FloatMesh, NothingHappensToAMeshThatFloatsCanTell) {
    const TriangleMesh mesh = placed(cube(), 0.1, {0.3, -0.7, 100});
    const FloatMesh rounded = round_to_floats(mesh);
    EXPECT_EQ(rounded.triangles, mesh.triangles);
    EXPECT_EQ(rounded.face, mesh.face);
    ASSERT_EQ(rounded.points.size(), 8U);
    for (std::uint32_t v = 0; v < 8; ++v) {
        EXPECT_EQ(rounded.vertex[v], v);
        EXPECT_EQ(rounded.points[v], to_floats(mesh.vertices[v]));
    }
}

// Enough cubes for several tasks of each step. Every second cube touches the next in a corner,
// every fifth has a needle, and every seventh is too small for floats.
TEST(FloatMesh, DoesNotDependOnTheNumberOfThreads) {
    TriangleMesh mesh;
    for (int i = 0; i < 3000; ++i) {
        TriangleMesh next = placed(cube(), i % 7 == 3 ? 1e-9 : 1.0,
                                   {200 + 3.0 * (i % 50), 3.0 * (i / 50), i % 2 == 0 ? 5.0 : 4.0});
        if (i % 5 == 1) {
            next.vertices.push_back(next.vertices[5] - Vec3{1e-8, 0, 0});
            next.triangles[2] = {4, 8, 6};
            next.triangles.push_back({8, 5, 6});
            next.triangles[5] = {0, 8, 4};
            next.triangles.push_back({0, 5, 8});
            next.face.insert(next.face.end(), {1, 2});
        }
        const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
        const std::size_t triangles = mesh.triangles.size();
        mesh = united(std::move(mesh), next);
        if (i % 2 == 0 || i % 7 == 3 || i % 7 == 4) continue;
        // The first corner is the last corner of the preceding cube.
        for (std::size_t t = triangles; t < mesh.triangles.size(); ++t)
            std::ranges::replace(mesh.triangles[t], count, count - 1);
    }
    const auto bytes = [&](std::size_t threads) {
        std::ostringstream out;
        exporter::write_stl(out, mesh, threads);
        return out.str();
    };
    const std::string one = bytes(1);
    EXPECT_GT(one.size(), 30000U * 50U);
    EXPECT_TRUE(ncsim::test::soundness(ncsim::test::read_stl(one)).is_sound());
    for (const std::size_t threads : {2U, 5U})
        EXPECT_TRUE(bytes(threads) == one) << threads;
}

TEST(FloatMesh, CoordinatesAreSeenFromTheOrigin) {
    const FloatMesh rounded = round_to_floats(placed(cube(), 1.0, {1e6, 0, 0}), {1e6, 0, 2});
    EXPECT_EQ(rounded.points[1], (FloatPoint{1, 0, -2}));
}

TEST(FloatMesh, AnEdgeWithoutLengthInFloatsIsContracted) {
    TriangleMesh mesh = placed(cube(), 10.0, {100, 0, 0});
    // Next to the corner 5, on the edge to 4: a needle on the top and a needle on the first side.
    mesh.vertices.push_back({110.0 - 1e-7, 0.0, 10.0});
    mesh.triangles[2] = {4, 8, 6};
    mesh.triangles.push_back({8, 5, 6});
    mesh.triangles[5] = {0, 8, 4};
    mesh.triangles.push_back({0, 5, 8});
    mesh.face.insert(mesh.face.end(), {1, 2});
    ASSERT_TRUE(cda::check(mesh).is_closed());
    const Soundness found = written(mesh);
    EXPECT_TRUE(found.is_sound()) << to_string(found);
    EXPECT_EQ(found.triangles, 12U);
    EXPECT_DOUBLE_EQ(found.volume, 1000.0);
    EXPECT_EQ(farthest_moved(mesh), 0);
}

TEST(FloatMesh, ATriangleWithoutHeightInFloatsIsCutIntoItsNeighbour) {
    TriangleMesh mesh = placed(cube(), 10.0, {100, 0, 0});
    // Next to the edge between the top and the first side, on the side.
    mesh.vertices.push_back({104.0, 0.0, 10.0 - 1e-8});
    mesh.triangles[5] = {0, 5, 8};
    mesh.triangles.push_back({0, 8, 4});
    mesh.triangles.push_back({8, 5, 4});
    mesh.face.insert(mesh.face.end(), {2, 2});
    ASSERT_TRUE(cda::check(mesh).is_closed());
    const Soundness found = written(mesh);
    EXPECT_TRUE(found.is_sound()) << to_string(found);
    EXPECT_EQ(found.triangles, 14U);
    EXPECT_DOUBLE_EQ(found.volume, 1000.0);
    EXPECT_EQ(farthest_moved(mesh), 0);
    const FloatMesh rounded = round_to_floats(mesh);
    EXPECT_TRUE(std::is_sorted(rounded.face.begin(), rounded.face.end()));
    EXPECT_EQ(std::count(rounded.face.begin(), rounded.face.end(), 1U), 3)
        << "the top has one more";
}

TEST(FloatMesh, SurfacesThatTouchGetCornersOfTheirOwn) {
    // Contact along an edge, with separate vertices or with common vertices, and contact in a
    // corner.
    const TriangleMesh beside = placed(cube(), 1.0, {1, 1, 0});
    const TriangleMesh apart = united(cube(), beside);
    const TriangleMesh at_a_corner = united(cube(), placed(cube(), 1.0, {1, 1, 1}), {{0, 6}});
    for (const TriangleMesh& mesh : {apart, at_a_corner}) {
        const Soundness found = written(mesh);
        EXPECT_TRUE(found.is_sound()) << to_string(found);
        EXPECT_EQ(found.triangles, 24U);
        EXPECT_NEAR(found.volume, 2.0, 1e-5);
        EXPECT_EQ(farthest_moved(mesh), 1);
    }
    EXPECT_THROW(written(united(cube(), beside, {{0, 2}, {4, 6}})), std::invalid_argument)
        << "this edge has two faces in each direction: the pairs are ambiguous";
}

TEST(FloatMesh, AWallThatFloatsCannotTellKeepsBothSides) {
    // A frame around a hole, 1 nm thick. Its two sides cannot merge without a hole in the surface.
    const cda::Lattice lattice;
    const auto box = [&](cda::LatticePoint min, cda::LatticePoint max) {
        return cda::box_cell(min, max, lattice, cda::Origin{1});
    };
    cda::TreeCda frame(box({0, 0, 0}, {400000, 400000, 100}), lattice);
    frame.subtract(box({100000, 100000, -1}, {300000, 300000, 101}));
    TriangleMesh mesh = cda::triangulate(frame.boundary());
    for (Vec3& v : mesh.vertices)
        v = {v.x, v.y, 100.0 + 1e-3 * v.z};
    const Soundness found = written(mesh);
    EXPECT_TRUE(found.is_sound()) << to_string(found);
    EXPECT_GT(found.triangles, 12U);
    EXPECT_NEAR(found.volume, 0.0, found.area * step_of(mesh));
    EXPECT_LE(farthest_moved(mesh), 1);
}

TEST(FloatMesh, ShellsTooSmallForFloatsVanish) {
    const TriangleMesh large = placed(cube(), 10.0, {100, 0, 0});
    const TriangleMesh mesh = united(large, placed(cube(), 1e-7, {103, 40, 40}));
    const FloatMesh rounded = round_to_floats(mesh);
    EXPECT_EQ(rounded.triangles, large.triangles);
    EXPECT_TRUE(round_to_floats(placed(cube(), 1e-7, {103, 40, 40})).triangles.empty());
    EXPECT_TRUE(round_to_floats(placed(cube(), 0.0, {})).triangles.empty());
    EXPECT_TRUE(round_to_floats({}).triangles.empty());
}

// 100 tetrahedra have a corner in the same place, where a cube of five steps has 125 places. No
// corner moves farther than the proof states.
TEST(FloatMesh, CornersInOnePlaceMoveNoFartherThanTheyMust) {
    TriangleMesh mesh;
    ncsim::test::Random random(3);
    const auto somewhere = [&] {
        Vec3 v;
        for (int axis = 0; axis < 3; ++axis)
            v[axis] = 1e-3 * static_cast<double>(random.between(-50000, 50000));
        return v;
    };
    for (std::uint32_t n = 0; n < 100; ++n) {
        const Vec3 tip{64, 64, 64};
        const Vec3 a = somewhere(), b = somewhere(), c = somewhere();
        const bool is_right = dot(cross(a - tip, b - tip), c - tip) > 0.0;
        mesh.vertices.insert(mesh.vertices.end(), {tip, a, is_right ? b : c, is_right ? c : b});
        for (const auto& t : std::vector<std::array<std::uint32_t, 3>>{
                 {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) {
            mesh.triangles.push_back({4 * n + t[0], 4 * n + t[1], 4 * n + t[2]});
            mesh.face.push_back(n);
        }
    }
    const Soundness found = written(mesh);
    EXPECT_TRUE(found.is_sound()) << to_string(found);
    EXPECT_EQ(found.triangles, 400U);
    EXPECT_EQ(farthest_moved(mesh), 2);
}

TEST(FloatMesh, WhatIsNotClosedIsRefused) {
    TriangleMesh open = cube();
    open.triangles.pop_back();
    open.face.pop_back();
    TriangleMesh turned = cube();
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    TriangleMesh doubled = cube();
    doubled.triangles.push_back(doubled.triangles[0]);
    doubled.face.push_back(0);
    TriangleMesh pointed = cube();
    pointed.triangles.push_back({1, 1, 2});
    pointed.face.push_back(0);
    for (const TriangleMesh& mesh : {open, turned, doubled, pointed})
        EXPECT_THROW(round_to_floats(mesh), std::invalid_argument);
    EXPECT_THROW(round_to_floats(placed(cube(), 1e39, {})), std::runtime_error);
    EXPECT_THROW(round_to_floats(placed(cube(), std::nan(""), {})), std::runtime_error);
}

// Parts not much larger than the distance between floats. Most corners coincide, but the part must
// stay connected.
TEST(FloatMesh, PartsAsSmallAsAFewFloatsStaySound) {
    const TriangleMesh part = cda::triangulate(test::polytope_part().boundary());
    Box box;
    for (const Vec3& v : part.vertices)
        box.add(v);
    std::size_t kept = 0;
    for (const double size : {1e-2, 3e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5}) {
        SCOPED_TRACE(size);
        const double scale = size / norm(box.size());
        const TriangleMesh mesh = placed(part, scale, {-500, 700, 33});
        const Soundness found = written(mesh);
        EXPECT_TRUE(found.is_sound()) << to_string(found);
        EXPECT_LE(found.triangles, mesh.triangles.size());
        EXPECT_LE(farthest_moved(mesh), 3);
        kept += found.triangles;
    }
    EXPECT_GT(kept, 1000U) << "else there is nothing to see";
}

}  // namespace
}  // namespace ncsim::mesh
