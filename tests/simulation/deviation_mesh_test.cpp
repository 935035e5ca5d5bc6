// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of surfaces from designs that are known without a search.
#include "deviation_mesh.h"

#include "ncsim/base/angles.h"
#include "ncsim/cda/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ncsim::simulation {
namespace {

// Returns a box with two triangles a face: bottom, top, and the four sides.
TriangleMesh box(Vec3 min, Vec3 max) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({(i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y,
                                 (i & 4) != 0 ? max.z : min.z});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {1, 3, 7}, {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
    mesh.face = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    return mesh;
}

// Returns a prism along X with this profile, the lower side at z = 0.
TriangleMesh prism(double length, int steps, const std::function<double(double)>& height) {
    TriangleMesh mesh;
    const auto columns = static_cast<std::uint32_t>(steps + 1);
    for (const double x : {0.0, length}) {
        for (const bool top : {false, true}) {
            for (int i = 0; i <= steps; ++i) {
                const double y = 30.0 * i / steps;
                mesh.vertices.push_back({x, y, top ? height(y) : 0.0});
            }
        }
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    const std::uint32_t far = 2 * columns;
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
        const std::uint32_t low = i, up = columns + i;
        quad(low, low + 1, far + low + 1, far + low);
        quad(up, far + up, far + up + 1, up + 1);
        quad(low, up, up + 1, low + 1);
        quad(far + low, far + low + 1, far + up + 1, far + up);
    }
    quad(0, far, far + columns, columns);
    quad(columns - 1, 2 * columns - 1, far + 2 * columns - 1, far + columns - 1);
    mesh.face.assign(mesh.triangles.size(), 0);
    return mesh;
}

double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.vertices;
        sum += 0.5 * norm(cross(p[b] - p[a], p[c] - p[a]));
    }
    return sum;
}

double distance_from_box(Vec3 p, Vec3 min, Vec3 max) {
    Vec3 beyond;
    double inside = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        beyond[axis] = std::max({min[axis] - p[axis], 0.0, p[axis] - max[axis]});
        inside = std::min({inside, p[axis] - min[axis], max[axis] - p[axis]});
    }
    return inside >= 0.0 ? -inside : norm(beyond);
}

Design design_of(TriangleMesh mesh, double tolerance_mm) {
    Design design;
    design.mesh = std::move(mesh);
    design.tolerance_mm = tolerance_mm;
    return design;
}

TEST(DeviationMesh, VerticesHaveTheirDistancesFromABox) {
    const Vec3 min{-2, 1, 0}, max{38, 31, 9};
    const simulation::DeviationMesh made =
        deviation_mesh(box({0, 0, 0}, {40, 30, 10}), design_of(box(min, max), 0.1));
    ASSERT_EQ(made.deviation_mm.size(), made.mesh.vertices.size());
    EXPECT_EQ(made.tolerance_mm, 0.1);
    double deepest = 0.0, thickest = 0.0;
    for (std::size_t v = 0; v < made.mesh.vertices.size(); ++v) {
        EXPECT_NEAR(made.deviation_mm[v], distance_from_box(made.mesh.vertices[v], min, max), 1e-9);
        deepest = std::max(deepest, -made.deviation_mm[v]);
        thickest = std::max(thickest, made.deviation_mm[v]);
    }
    EXPECT_NEAR(deepest, 2.0, 0.05);  // the side at x = 0
    EXPECT_NEAR(thickest, std::sqrt(2.0 * 2.0 + 1.0 + 1.0), 1e-9);
}

TEST(DeviationMesh, KeepsTheSurfaceAndItsFaces) {
    const TriangleMesh part = box({0, 0, 0}, {40, 30, 10});
    const simulation::DeviationMesh made =
        deviation_mesh(part, design_of(box({1, 1, 1}, {39, 31, 9}), 0.05));
    EXPECT_GT(made.mesh.triangles.size(), 100U);
    EXPECT_TRUE(cda::check(made.mesh).is_closed());
    EXPECT_NEAR(cda::volume(made.mesh), 12000.0, 1e-6);
    EXPECT_NEAR(area(made.mesh), area(part), 1e-6);
    for (std::size_t v = 0; v < part.vertices.size(); ++v)
        EXPECT_EQ(made.mesh.vertices[v], part.vertices[v]);
    // Each triangle lies in the plane of its face.
    ASSERT_EQ(made.mesh.face.size(), made.mesh.triangles.size());
    for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
        const std::uint32_t face = made.mesh.face[t];
        const auto& [a, b, c] = part.triangles[2 * face];
        const Vec3 n = normalized(
            cross(part.vertices[b] - part.vertices[a], part.vertices[c] - part.vertices[a]));
        for (const std::uint32_t v : made.mesh.triangles[t])
            EXPECT_NEAR(dot(n, made.mesh.vertices[v] - part.vertices[a]), 0.0, 1e-9);
    }
}

// The design is a wave, the part a flat plate: between any two adjacent vertices the distance is
// linear within half of the tolerance.
TEST(DeviationMesh, DistancesBetweenVerticesAreLinear) {
    const auto wave = [](double y) { return 9.0 + sin_cos(24.0 * y).sin; };
    const Design design = design_of(prism(40.0, 240, wave), 0.1);
    const simulation::DeviationMesh made = deviation_mesh(box({0, 0, 0}, {40, 30, 9}), design);
    const double size = norm(Vec3{40, 30, 9});
    const auto& p = made.mesh.vertices;
    std::size_t top = 0;
    for (const auto& t : made.mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            const bool is_top = p[a].z > 8.9 && p[b].z > 8.9 && p[a].x > 5 && p[a].x < 35;
            if (!is_top || norm(p[a] - p[b]) < 2.0 * size / 1000) continue;
            ++top;
            // The surface of the design is known: the distance is at most the height above.
            const Vec3 middle = 0.5 * (p[a] + p[b]);
            const double mean = 0.5 * (made.deviation_mm[a] + made.deviation_mm[b]);
            const double above = middle.z - wave(middle.y);
            if (std::abs(above) > 0.2) {
                EXPECT_GT(mean * above, 0.0);
            }
            EXPECT_LE(std::abs(mean), std::abs(above) + 0.06);
            EXPECT_GE(std::abs(mean), 0.9 * std::abs(above) - 0.06);
        }
    }
    EXPECT_GT(top, 500U);
    const auto [least, most] = std::ranges::minmax(made.deviation_mm);
    EXPECT_NEAR(least, -1.0, 0.02);
    EXPECT_NEAR(most, 1.0, 0.02);
}

}  // namespace
}  // namespace ncsim::simulation
