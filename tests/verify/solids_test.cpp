// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separate solids of a part: number, volumes and faces.
#include "ncsim/verify/solids.h"

#include "ncsim/cda/tree.h"

#include <gtest/gtest.h>

namespace ncsim::verify_test {
namespace {

using verify::Solids;

const cda::Lattice kLattice;

cda::Cell box(double x0, double y0, double z0, double x1, double y1, double z1,
              std::uint32_t origin = 0) {
    return cda::box_cell(kLattice.round({x0, y0, z0}), kLattice.round({x1, y1, z1}), kLattice,
                         cda::Origin{origin});
}

TEST(Solids, AreCountedWithVolumesAndFaces) {
    cda::TreeCda part(box(0, 0, 0, 30, 10, 10), kLattice);
    EXPECT_EQ(Solids(part.boundary()).all().size(), 1U);
    part.subtract_unmeasured(box(20, -1, -1, 21, 11, 5, 1));  // half way through
    EXPECT_EQ(Solids(part.boundary()).all().size(), 1U);
    part.subtract_unmeasured(box(20, -1, 5, 21, 11, 11, 2));
    const Solids solids(part.boundary());
    ASSERT_EQ(solids.all().size(), 2U);
    EXPECT_NEAR(solids.all()[0].volume_mm3, 2000.0, 1e-6);
    EXPECT_NEAR(solids.all()[1].volume_mm3, 900.0, 1e-6);
    EXPECT_EQ(solids.all()[1].origins, (std::vector{cda::Origin{1}, cda::Origin{2}}));
    EXPECT_EQ(solids.at({10.1, 5.2, 5.3}), 0U);
    EXPECT_EQ(solids.at({25.1, 5.2, 5.3}), 1U);
    EXPECT_EQ(solids.at({20.5, 5.2, 5.3}), std::nullopt);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(solids.at(*solids.all()[i].inner_point), i);
}

TEST(Solids, ThatTouchInAnEdgeAreTwo) {
    cda::TreeCda part(box(0, 0, 0, 10, 10, 10), kLattice);
    part.subtract_unmeasured(box(-1, 5, -1, 5, 11, 11, 1));
    part.subtract_unmeasured(box(5, -1, -1, 11, 5, 11, 2));
    EXPECT_EQ(Solids(part.boundary()).all().size(), 2U);
}

TEST(Solids, DoNotCountHollows) {
    cda::TreeCda part(box(0, 0, 0, 10, 10, 10), kLattice);
    part.subtract_unmeasured(box(2, 2, 2, 4, 4, 4, 1));
    EXPECT_EQ(Solids(part.boundary()).all().size(), 1U);
}

}  // namespace
}  // namespace ncsim::verify_test
