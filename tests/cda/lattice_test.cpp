// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the choice of the lattice, rounding, and canonical planes.
#include "ncsim/cda/lattice.h"

#include "ncsim/cda/plane.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

TEST(Lattice, IsTenNanometresForStockUpTo335Millimetres) {
    EXPECT_EQ(Lattice::for_stock({{-335, 0, 0}, {335, 10, 10}}).unit_mm, 1e-5);
    EXPECT_EQ(Lattice::for_stock({{-336, 0, 0}, {10, 10, 10}}).unit_mm, 2e-5);
    EXPECT_EQ(Lattice::for_stock({{0, 0, 0}, {0, 0, 1500}}).unit_mm, 5e-5);
}

TEST(Lattice, RoundsToTheNearestPointHalvesAwayFromZero) {
    const Lattice lattice{1.0};
    EXPECT_EQ(lattice.round({0.5, -0.5, 1.49}), (LatticePoint{1, -1, 1}));
}

TEST(Lattice, ClampsWhatNoMachineReaches) {
    EXPECT_EQ(Lattice{1e-5}.round({1e300, -1e300, 0}), (LatticePoint{kMaxPose, -kMaxPose, 0}));
}

TEST(Plane, IsCanonicalSoThatEqualPlanesAreEqualValues) {
    EXPECT_EQ(canonical(2, 4, -6, 8), (Plane{1, 2, -3, 4}));
    EXPECT_EQ(canonical(2, 4, -6, 7), (Plane{2, 4, -6, 7}));
}

TEST(Plane, KnowsItsParallels) {
    EXPECT_TRUE((Plane{1, 2, 3, 0}.is_parallel_to({-2, -4, -6, 1})));
    EXPECT_FALSE((Plane{1, 2, 3, 0}.is_parallel_to({1, 2, 2, 0})));
}

}  // namespace
}  // namespace ncsim::cda
