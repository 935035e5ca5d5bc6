// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places where a cell meets the part: small boxes around the material, whatever the longest side of
// the cell.
#include "body.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <vector>

namespace ncsim::verify_test {
namespace {

TEST(FindPlaces, EncloseTheMaterialInSmallBoxes) {
    const cda::Lattice lattice = cda::Lattice::for_stock(kBlock);
    const auto cell = [&](Vec3 a, Vec3 b) {
        return cda::box_cell(lattice.round(a), lattice.round(b), lattice);
    };
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE("XYZ"[axis]);
        // The block is cut away but for a slice of 1 mm, from 3 to 4 mm behind its lower end.
        cda::TreeCda part(cell(kBlock.min, kBlock.max), lattice);
        const double begin = kBlock.min[axis] + 3.0;
        Box before = kBlock, behind = kBlock;
        before.max[axis] = begin;
        behind.min[axis] = begin + 1.0;
        part.subtract(cell(before.min, before.max));
        part.subtract(cell(behind.min, behind.max));
        // A rod of 0.8 mm along the axis, longer than the block.
        Vec3 from{-0.4, -0.4, -5.4}, to{0.4, 0.4, -4.6};
        from[axis] = -50.0, to[axis] = 50.0;
        std::vector<Box> places;
        verify::find_places(cell(from, to), part, kBlock, places);
        ASSERT_FALSE(places.empty());
        Box all;
        for (const Box& place : places) {
            EXPECT_LE(place.size()[axis], 1.0);
            all.add(place);
        }
        EXPECT_LE(all.min[axis], begin);
        EXPECT_GE(all.max[axis], begin + 1.0);
        EXPECT_GE(all.min[axis], begin - 1.0);
        EXPECT_LE(all.max[axis], begin + 2.0);
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            EXPECT_NEAR(all.min[other], from[other], 1e-4);
            EXPECT_NEAR(all.max[other], to[other], 1e-4);
        }
    }
}

TEST(FindPlaces, AreNoneWithoutMaterial) {
    const cda::Lattice lattice = cda::Lattice::for_stock(kBlock);
    cda::TreeCda part(cda::box_cell(lattice.round(kBlock.min), lattice.round(kBlock.max), lattice),
                      lattice);
    std::vector<Box> places;
    verify::find_places(
        cda::box_cell(lattice.round({21, -1, -9}), lattice.round({29, 1, -1}), lattice), part,
        kBlock, places);
    for (const Box& place : places)
        EXPECT_TRUE(place.is_empty());
}

}  // namespace
}  // namespace ncsim::verify_test
