// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the reports of places that are too thin for the rays.
#include "ncsim/cda/check.h"
#include "ncsim/dexel/dexel.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>

namespace ncsim::dexel {
namespace {

using cda::Cell;
using cda::LatticePoint;
using test::kLattice;
using test::mm_box;

std::unique_ptr<cda::WorkpieceModel> block(double resolution,
                                           Directions directions = Directions::Three) {
    return Dexel({1, resolution, directions}).create(mm_box(0, 0, 0, 10, 10, 6), kLattice);
}

Cell box(Vec3 min, Vec3 max, std::uint32_t motion) {
    return cda::box_cell(kLattice.round(min), kLattice.round(max), kLattice, cda::Origin{motion});
}

TEST(ThinPlaces, APlainBlockHasNone) {
    const auto found = block(0.4)->aliasing();
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->material.count, 0U);
    EXPECT_EQ(found->gaps.count, 0U);
    EXPECT_EQ(found->material.thinnest_mm, 0.0);
    EXPECT_FALSE(found->checks_only_along_z);
}

// Three pockets with two ribs of 0.2 mm in between, and rays of 0.4 mm pitch. Exactly one rib
// contains corners of the grid and is in the surface.
TEST(ThinPlaces, ARibBetweenRaysIsTold) {
    const auto part = block(0.4);
    part->subtract_unmeasured(box({1, 1, 2}, {2.7, 9, 7}, 1));
    part->subtract_unmeasured(box({2.9, 1, 2}, {4.9, 9, 7}, 2));
    part->subtract_unmeasured(box({5.1, 1, 2}, {9, 9, 7}, 3));
    const auto found = part->aliasing();
    // Rays along X, 0.4 mm apart, through 8 × 4 mm of each rib.
    EXPECT_EQ(found->material.count, 400U);
    EXPECT_EQ(found->material.missing, 200U);
    EXPECT_NEAR(found->material.missing_mm3, 0.2 * 8 * 4, 1e-6);
    EXPECT_NEAR(found->material.thinnest_mm, 0.2, 1e-9);
    EXPECT_NEAR(found->material.at.x, 2.8, 1e-9);
    EXPECT_EQ(found->material.origin, cda::Origin{2});
    EXPECT_EQ(found->gaps.count, 0U);
    EXPECT_NEAR(cda::volume(part->boundary()), 600 - 8 * 8 * 4 + 0.2 * 8 * 4, 0.3);
}

// For any position of the grid, a slot wider than the pitch is in the surface, and a slot of half a
// pitch is reported.
TEST(ThinPlaces, ASlotIsShownOrTold) {
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        const double pitch = 0.4;
        const double x = 3.0 + 0.01 * i;
        const auto wide = block(pitch);
        wide->subtract_unmeasured(box({x, -1, 2}, {x + 1.01 * pitch, 11, 7}, 1));
        EXPECT_EQ(wide->aliasing()->gaps.count, 0U);
        EXPECT_FALSE(wide->contains({x + 0.5 * pitch, 5, 4}) &&
                     wide->contains({x + 0.1 * pitch, 5, 4}) &&
                     wide->contains({x + 0.9 * pitch, 5, 4}));
        const auto narrow = block(pitch);
        narrow->subtract_unmeasured(box({x, -1, 2}, {x + 0.5 * pitch, 11, 7}, 1));
        EXPECT_EQ(narrow->aliasing()->gaps.count, 25U * 10U);
        EXPECT_NEAR(narrow->aliasing()->gaps.thinnest_mm, 0.2, 1e-9);
    }
}

TEST(ThinPlaces, AlongZAloneWallsAreNotLookedForAndThatIsTold) {
    const auto part = block(0.4, Directions::OnlyZ);
    part->subtract_unmeasured(box({1, 1, 2}, {4.9, 9, 7}, 1));
    part->subtract_unmeasured(box({5.1, 1, 2}, {9, 9, 7}, 2));
    EXPECT_TRUE(part->aliasing()->checks_only_along_z);
    EXPECT_EQ(part->aliasing()->material.count, 0U);
    // A thin floor is reported.
    part->subtract_unmeasured(box({1, 1, 0.1}, {4, 4, 3}, 3));
    EXPECT_GT(part->aliasing()->material.count, 40U);
    EXPECT_NEAR(part->aliasing()->material.thinnest_mm, 0.1, 1e-9);
}

}  // namespace
}  // namespace ncsim::dexel
