// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/check.h"

#include "ncsim/brep/apart.h"

#include "brep/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr double kTolerance = 1e-9;

std::string told(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults)
        text += "face " + std::to_string(fault.face) + ": " + fault.what + "\n";
    return text;
}

TEST(Check, FindsNothingAgainstSoundSolids) {
    for (test::NamedPart& solid : test::solids()) {
        SCOPED_TRACE(solid.name);
        EXPECT_EQ(told(check(solid.part, kTolerance)), "");
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

TEST(Check, FindsALoopTheWrongWayRound) {
    Part part = solid_named("cylinder").part;
    for (Loop& loop : part.faces[1].loops) {
        for (EdgeUse& use : loop)
            use.is_forward = !use.is_forward;
    }
    EXPECT_NE(told(check(part, kTolerance)), "");
}

TEST(Check, FindsAnEdgeOffItsSurface) {
    Part part = solid_named("slotted_box").part;
    auto& wall = std::get<Plane>(part.faces[7].surface.form);
    wall.origin = wall.origin + Vec3{0, 1e-4, 0};
    EXPECT_NE(told(check(part, kTolerance)).find("off the surface"), std::string::npos);
    EXPECT_NEAR(part.miss_mm, 1e-4, 1e-9);
}

TEST(Check, FindsLoopsThatCross) {
    Part part = solid_named("bored_box").part;
    for (Edge& edge : part.edges) {
        auto* circle = std::get_if<Circle>(&edge.curve);
        if (!circle) continue;
        // Beyond the side of the box.
        circle->centre.x += 9;
        part.vertices[edge.from].x += 9;
    }
    for (Face& face : part.faces) {
        if (auto* bore = std::get_if<Cylinder>(&face.surface.form)) bore->origin.x += 9;
    }
    EXPECT_NE(told(check(part, kTolerance)).find("cross or touch"), std::string::npos);
}

TEST(Check, FindsTheLongWayRound) {
    Part part = solid_named("slotted_box").part;
    for (Edge& edge : part.edges) {
        auto* circle = std::get_if<Circle>(&edge.curve);
        if (circle) circle->axis = -circle->axis;
    }
    EXPECT_NE(told(check(part, kTolerance)), "");
}

// A post of five corners, two of them 1.4e-8 mm apart: readers take these for one, and find its
// walls open.
TEST(Apart, KeepsCornersThatReadersWouldTakeForOne) {
    cda::Boundary post;
    const double near = 1e-8;
    for (const double z : {0.0, 5.0}) {
        for (const auto& [x, y] : {std::pair{0.0, 0.0},
                                   {10.0, 0.0},
                                   {10.0, 10.0 - near},
                                   {10.0 - near, 10.0},
                                   {0.0, 10.0}})
            post.vertices.push_back({x, y, z});
    }
    post.shells = 1;
    const double diagonal = std::sqrt(0.5);
    const Vec3 normals[] = {{0, -1, 0}, {1, 0, 0}, {diagonal, diagonal, 0}, {0, 1, 0}, {-1, 0, 0}};
    for (std::uint32_t i = 0; i < 5; ++i) {
        const std::uint32_t j = (i + 1) % 5;
        post.faces.push_back({normals[i], 0.0, cda::kStockOrigin, 0, {{i, j, j + 5, i + 5}}});
    }
    post.faces.push_back({{0, 0, 1}, 5.0, cda::kStockOrigin, 0, {{5, 6, 7, 8, 9}}});
    post.faces.push_back({{0, 0, -1}, 0.0, cda::kStockOrigin, 0, {{4, 3, 2, 1, 0}}});
    Part part = faceted(post, std::vector<std::vector<cda::Origin>>(7, {cda::kStockOrigin}));
    keep_apart(part);
    EXPECT_EQ(part.edges.size(), 15U);
    for (const Edge& edge : part.edges)
        EXPECT_GT(cda::norm(part.vertices[edge.to] - part.vertices[edge.from]), 9e-6);
    EXPECT_EQ(told(check(part, 1e-4)), "");
}

}  // namespace
}  // namespace ncsim::brep
