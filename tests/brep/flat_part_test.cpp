// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests solids of facets: sound input, crossing loops, open shells and voids.
#include "ncsim/brep/flat_part.h"

#include "ncsim/brep/measure.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::brep {
namespace {

// Returns a cube of 10 mm with a four-sided pit in its top that ends in a point, shifted by
// `to_the_right` (mm) in X.
Facets pitted_block(double to_the_right) {
    cda::Boundary block;
    block.vertices = {{0, 0, 0},   {10, 0, 0},   {10, 10, 0}, {0, 10, 0}, {0, 0, 10},
                      {10, 0, 10}, {10, 10, 10}, {0, 10, 10}, {3, 3, 10}, {7, 3, 10},
                      {7, 7, 10},  {3, 7, 10},   {5, 5, 6}};
    for (std::size_t i = 8; i < block.vertices.size(); ++i)
        block.vertices[i].x += to_the_right;
    const auto face = [&](std::vector<std::vector<std::uint32_t>> loops) {
        cda::BoundaryFace made;
        const Vec3 a = block.vertices[loops[0][0]];
        made.normal =
            normalized(cross(block.vertices[loops[0][1]] - a, block.vertices[loops[0][2]] - a));
        made.offset = dot(made.normal, a);
        made.loops = std::move(loops);
        block.faces.push_back(made);
    };
    face({{3, 2, 1, 0}});
    face({{4, 5, 6, 7}, {11, 10, 9, 8}});
    for (std::uint32_t i = 0; i < 4; ++i)
        face({{i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4}});
    for (std::uint32_t i = 0; i < 4; ++i)
        face({{8 + i, 8 + (i + 1) % 4, 12}});
    block.shells = 1;
    const std::size_t faces = block.faces.size();
    return {std::move(block), std::vector<std::vector<cda::Origin>>(faces, {cda::kStockOrigin})};
}

constexpr double kInside = 1.0, kAcrossTheEdge = 4.0;

TEST(FlatPart, WhatIsSoundIsLeftAsItIs) {
    const FlatPart flat = flat_part([](double) { return pitted_block(kInside); });
    EXPECT_TRUE(flat.is_sound);
    EXPECT_EQ(flat.tolerance_factor, 1.0);
    EXPECT_EQ(flat.part.faces.size(), 10U);
}

TEST(FlatPart, WhereLoopsCrossCoarserFacetsAreTaken) {
    const FlatPart flat = flat_part(
        [](double times) { return pitted_block(times < 16.0 ? kAcrossTheEdge : kInside); });
    EXPECT_TRUE(flat.is_sound);
    EXPECT_EQ(flat.tolerance_factor, 16.0);
}

TEST(FlatPart, WhatStaysCrossedIsNotSound) {
    const FlatPart flat = flat_part([](double) { return pitted_block(kAcrossTheEdge); });
    EXPECT_FALSE(flat.is_sound);
    EXPECT_EQ(flat.tolerance_factor, 1.0);
}

TEST(FlatPart, OpenOnesAndThoseOfAnotherVolumeAreNotSound) {
    const Facets block = pitted_block(kInside);
    Part part = faceted(block.boundary, block.origins);
    const double right = volume(part);
    EXPECT_TRUE(is_sound_polyhedron(part, right));
    EXPECT_FALSE(is_sound_polyhedron(part, right + 1.0));
    part.faces.pop_back();
    part.solids.front().outside.pop_back();
    EXPECT_FALSE(is_sound_polyhedron(part, volume(part)));
}

// A void that is written alone has no enclosing shell. Its faces are kept, and its volume is
// negative.
TEST(FlatPart, AVoidByItselfHasItsFaces) {
    Facets block = pitted_block(kInside);
    for (cda::BoundaryFace& face : block.boundary.faces) {
        face.normal = -face.normal;
        face.offset = -face.offset;
        for (auto& loop : face.loops)
            loop = {loop.rbegin(), loop.rend()};
    }
    const FlatPart flat = flat_part([&](double) { return block; });
    EXPECT_TRUE(flat.is_sound);
    EXPECT_EQ(flat.part.faces.size(), 10U);
    EXPECT_NEAR(volume(flat.part), -(1000.0 - 16.0 * 4.0 / 3.0), 1e-9);
}

}  // namespace
}  // namespace ncsim::brep
