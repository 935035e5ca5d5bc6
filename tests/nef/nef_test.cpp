// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the exact model with an independent model, corner by corner: in scenes of unit cubes,
// where every coincidence occurs, and in oblique scenes.
#include "nef/agreement.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace ncsim::test {
namespace {

TEST(Nef, KnowsACubeWithANotch) {
    NefPart part(mm_box(0, 0, 0, 2, 2, 2));
    EXPECT_EQ(part.corners().size(), 8U);
    part.subtract(mm_box(1, 1, 1, 3, 3, 3));
    EXPECT_EQ(part.corners().size(), 14U);
    EXPECT_DOUBLE_EQ(part.volume(), 7e15);
    part.subtract(mm_box(-1, -1, -1, 3, 3, 3));
    EXPECT_TRUE(part.corners().empty());
    EXPECT_EQ(part.volume(), 0.0);
}

TEST(Nef, AgreesInScenesOfUnitCubes) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        EXPECT_EQ(disagreement_of_boxes(seed), "");
    }
}

TEST(Nef, AgreesInObliqueScenes) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        EXPECT_EQ(disagreement_of_hulls(seed), "");
    }
}

// A corner that is off by a unit is found.
TEST(Nef, DisagreesWithAnotherPart) {
    const cda::Cell stock = mm_box(0, 0, 0, 2, 2, 2);
    cda::Cell cut = mm_box(1, 1, 1, 3, 3, 3);
    cda::Cell other = cut;
    for (cda::Plane& plane : other.planes) {
        if (plane.nx == -1) ++plane.d;
    }
    EXPECT_EQ(disagreement(stock, {cut}, {cut}), "");
    EXPECT_NE(disagreement(stock, {cut}, {other}), "");
}

TEST(Nef, AgreesOnTheFirstSample) {
    EXPECT_EQ(disagreement_of_program(NCSIM_SOURCE_DIR "/samples/simple.nc", 10), "");
}

}  // namespace
}  // namespace ncsim::test
