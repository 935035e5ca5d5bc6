// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests binary STL files: contents, and closed surfaces in floats.
#include "ncsim/export/stl.h"

#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"

#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace ncsim::exporter {
namespace {

std::string written(const TriangleMesh& mesh) {
    std::ostringstream out;
    write_stl(out, mesh);
    return out.str();
}

float float_at(const std::string& bytes, std::size_t at) {
    float value = 0;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
}

constexpr std::size_t kHeader = 84;
constexpr std::size_t kTriangle = 50;

// Returns a tetrahedron with a, b, c counter-clockwise seen from outside, and d behind.
TriangleMesh tetrahedron(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return {{a, b, c, d}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, {0, 1, 2, 3}};
}

TEST(WriteStl, WritesTheTriangleAndItsNormal) {
    const std::string bytes = written(tetrahedron({0, 0, 2}, {3, 0, 2}, {0, 4.5, 2}, {0, 0, 0}));
    ASSERT_EQ(bytes.size(), kHeader + 4 * kTriangle);
    EXPECT_EQ(bytes[80], 4);
    const std::array<float, 12> expected{0, 0, 1, 0, 0, 2, 3, 0, 2, 0, 4.5, 2};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(float_at(bytes, kHeader + 4 * i), expected[i]) << i;
    }
}

TEST(WriteStl, DoesNotBeginLikeTheTextForm) {
    EXPECT_NE(written({}).substr(0, 5), "solid");
}

TEST(WriteStl, AMeshWithoutTrianglesIsAHeader) {
    EXPECT_EQ(written({}).size(), kHeader);
    EXPECT_EQ(written({}).substr(80), std::string(4, '\0'));
}

std::uint32_t count_of(const std::string& bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes[80], sizeof value);
    return value;
}

TEST(WriteStl, LeavesOutWhatVanishesInFloats) {
    // A needle next to an edge of a tetrahedron, and a tetrahedron too thin for floats.
    TriangleMesh mesh = tetrahedron({1e6, 0, 1}, {1e6 + 1, 0, 1}, {1e6, 1, 1}, {1e6, 0, 0});
    mesh.vertices.push_back({1e6 + 1e-9, 1, 1});
    mesh.triangles = {{0, 1, 4}, {0, 4, 2}, {0, 3, 1}, {1, 3, 4}, {4, 3, 2}, {2, 3, 0}};
    mesh.face = {0, 0, 1, 2, 2, 3};
    EXPECT_EQ(count_of(written(mesh)), 4U);
    const std::string flat =
        written(tetrahedron({1e6, 0, 0}, {1e6, 1, 0}, {1e6, 0, 1}, {1e6 - 1e-9, 0, 0}));
    EXPECT_EQ(flat.size(), kHeader);
    EXPECT_EQ(count_of(flat), 0U);
}

TEST(WriteStl, RefusesAMeshThatIsNotClosed) {
    EXPECT_THROW(written({{{0, 0, 2}, {3, 0, 2}, {0, 4.5, 2}}, {{0, 1, 2}}, {0}}),
                 std::invalid_argument);
}

// Every edge of the file occurs equally often in both directions, and the corners of each triangle
// differ.
TEST(WriteStl, StaysClosedInFloats) {
    const TriangleMesh mesh = cda::triangulate(test::polytope_part().boundary());
    const std::string bytes = written(mesh);
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> edges;
    for (std::uint32_t t = 0; t < count_of(bytes); ++t) {
        std::array<Point, 3> corners{};
        std::memcpy(&corners, &bytes[kHeader + t * kTriangle + 12], sizeof corners);
        for (std::size_t i = 0; i < 3; ++i) {
            const Point& a = corners[i];
            const Point& b = corners[(i + 1) % 3];
            ASSERT_NE(a, b);
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    }
    EXPECT_GT(edges.size(), 100U);
    for (const auto& [edge, sum] : edges)
        EXPECT_EQ(sum, 0);
}

// Readers pair edges by coordinates. Each edge must occur once in each direction even if surfaces
// touch along edges and in corners.
TEST(WriteStl, SurfacesThatTouchAreToldApart) {
    const cda::Lattice lattice;
    const auto box = [&](Vec3 min, Vec3 max) {
        return cda::box_cell(lattice.round(min), lattice.round(max), lattice, cda::Origin{1});
    };
    // Four cubes of a block of eight are left. Each touches the rest along its edges.
    cda::TreeCda part(box({0, 0, 0}, {2, 2, 2}), lattice);
    for (const Vec3 min : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
        part.subtract(box(min, min + Vec3{1, 1, 1}));
    const std::string bytes = written(cda::triangulate(part.boundary()));
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> edges;
    for (std::uint32_t t = 0; t < count_of(bytes); ++t) {
        std::array<Point, 3> corners{};
        std::memcpy(&corners, &bytes[kHeader + t * kTriangle + 12], sizeof corners);
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{corners[i], corners[(i + 1) % 3]}];
    }
    EXPECT_EQ(edges.size(), 3U * 4 * 12);
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
        for (const float coordinate : edge.first)
            EXPECT_NEAR(coordinate, std::round(coordinate), 1e-6);
    }
}

TEST(WriteStl, KnowsOnlyOneZero) {
    const std::string bytes =
        written(tetrahedron({-0.0, 0, -0.0}, {1, 0, 0}, {0, 1, -1e-300}, {0, 0, -1}));
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_FALSE(std::signbit(float_at(bytes, kHeader + 4 * i))) << i;
    }
}

TEST(WriteStl, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_stl(out, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
