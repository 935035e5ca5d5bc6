// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests simplify() without a tolerance, which only merges faces.
#include "ncsim/cda/check.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/mesh/simplify.h"

#include "support/box_part.h"
#include "support/polytope_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::mesh {
namespace {

TEST(MergeFaces, ABoxOfManySquaresHasSixFacesAndEightCorners) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {3, 4, 5}};
    const Simplified merged = simplify(test::boundary_of(box), 0.0);
    ASSERT_EQ(merged.boundary.faces.size(), 6U);
    for (const auto& face : merged.boundary.faces) {
        ASSERT_EQ(face.loops.size(), 1U);
        EXPECT_EQ(face.loops[0].size(), 4U);
    }
    EXPECT_DOUBLE_EQ(cda::volume(merged.boundary), 60.0);
}

TEST(MergeFaces, CountsFacesAsAPersonDoes) {
    EXPECT_EQ(simplify(test::boundary_of(test::grooved_part()), 0.0).boundary.faces.size(), 25U);
    EXPECT_EQ(simplify(test::boundary_of(test::grooved_part().tilted()), 0.0).boundary.faces.size(),
              25U);
    EXPECT_EQ(simplify(test::plate_with_hole(), 0.0).boundary.faces.size(), 10U);
}

TEST(MergeFaces, APocketIsAHoleInTheFaceAroundIt) {
    test::BoxPart part;
    part.stock = {{0, 0, 0}, {6, 6, 4}};
    part.cuts = {{{1, 1, 2}, {3, 3, 5}}, {{4, 1, 2}, {5, 5, 5}}};
    const Simplified merged = simplify(test::boundary_of(part), 0.0);
    std::size_t pierced = 0;
    for (const auto& face : merged.boundary.faces) {
        if (face.loops.size() == 1) continue;
        ++pierced;
        EXPECT_EQ(face.loops.size(), 3U);
        EXPECT_EQ(face.normal, (Vec3{0, 0, 1}));
    }
    EXPECT_EQ(pierced, 1U);
}

// Returns a block of 4 × 4 × 3. Its top is fourteen squares and two pits, inverted pyramids that
// meet in a point in the middle of the top.
cda::Boundary block_with_touching_pits() {
    cda::Boundary b;
    const auto top = [](std::uint32_t x, std::uint32_t y) { return 5 * y + x; };
    for (int y = 0; y <= 4; ++y) {
        for (int x = 0; x <= 4; ++x) {
            b.vertices.push_back({static_cast<double>(x), static_cast<double>(y), 3});
        }
    }
    b.vertices.insert(b.vertices.end(), {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});  // 25 … 28
    b.vertices.insert(b.vertices.end(), {{1.5, 1.5, 2}, {2.5, 2.5, 2}});                // 29, 30
    const auto add = [&](Vec3 n, std::vector<std::uint32_t> loop) {
        b.faces.push_back({n, 0, cda::kStockOrigin, 0, {std::move(loop)}});
    };
    add({0, 0, -1}, {28, 27, 26, 25});
    add({0, -1, 0}, {25, 26, 4, 3, 2, 1, 0});
    add({1, 0, 0}, {26, 27, 24, 19, 14, 9, 4});
    add({0, 1, 0}, {27, 28, 20, 21, 22, 23, 24});
    add({-1, 0, 0}, {28, 25, 0, 5, 10, 15, 20});
    const double s = 1.0 / std::sqrt(1.25);
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::array corners{top(x, y), top(x + 1, y), top(x + 1, y + 1), top(x, y + 1)};
            if (x != y || x == 0 || x == 3) {
                add({0, 0, 1}, {corners.begin(), corners.end()});
                continue;
            }
            const std::array<Vec3, 4> normals{
                {{0, s, s / 2}, {-s, 0, s / 2}, {0, -s, s / 2}, {s, 0, s / 2}}};
            for (std::size_t i = 0; i < 4; ++i) {
                add(normals[i], {corners[i], corners[(i + 1) % 4], x == 1 ? 29U : 30U});
            }
        }
    }
    b.shells = 1;
    return b;
}

TEST(MergeFaces, HolesThatTouchInAVertexStayHoles) {
    const cda::Boundary boundary = block_with_touching_pits();
    ASSERT_TRUE(cda::check(boundary).is_closed());
    const Simplified merged = simplify(boundary, 0.0);
    EXPECT_TRUE(cda::check(merged.boundary).is_closed());
    EXPECT_NEAR(cda::volume(merged.boundary), 48.0 - 2.0 / 3.0, 1e-12);
    ASSERT_EQ(merged.boundary.faces.size(), 6U + 8U);
    const auto top = std::find_if(merged.boundary.faces.begin(), merged.boundary.faces.end(),
                                  [](const auto& face) { return face.normal.z == 1.0; });
    ASSERT_EQ(top->loops.size(), 3U);
    for (const auto& loop : top->loops)
        EXPECT_EQ(loop.size(), 4U);
}

TEST(MergeFaces, KeepsTheSurfaceClosedAndTheVolume) {
    for (const cda::Boundary& boundary :
         {test::boundary_of(test::raster_part().tilted()), test::polytope_part().boundary(),
          test::plate_with_hole(), test::boundary_of(test::hollow_part())}) {
        const Simplified merged = simplify(boundary, 0.0);
        EXPECT_TRUE(cda::check(merged.boundary).is_closed());
        EXPECT_LE(merged.boundary.faces.size(), boundary.faces.size());
        EXPECT_NEAR(cda::volume(merged.boundary), cda::volume(boundary),
                    1e-12 * cda::volume(boundary));
        EXPECT_TRUE(cda::check(cda::triangulate(merged.boundary)).is_closed());
    }
}

TEST(MergeFaces, RemembersWhoCutAFace) {
    const Simplified merged = simplify(test::boundary_of(test::grooved_part()), 0.0);
    ASSERT_EQ(merged.origins.size(), merged.boundary.faces.size());
    // Three passes cut the floor of the groove.
    const bool found = std::any_of(merged.origins.begin(), merged.origins.end(), [](const auto& o) {
        return o == std::vector{cda::Origin{1}, cda::Origin{2}, cda::Origin{3}};
    });
    EXPECT_TRUE(found);
}

TEST(MergeFaces, OfNothingIsNothing) {
    EXPECT_TRUE(simplify({}, 0.0).boundary.faces.empty());
}

}  // namespace
}  // namespace ncsim::mesh
