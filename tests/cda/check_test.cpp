// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests that surfaces with gaps are detected.
#include "ncsim/cda/check.h"

#include "ncsim/cda/tree.h"

#include "support/random_shapes.h"
#include "surface/stitch.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;

Boundary notched_block() {
    TreeCda part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    part.subtract(mm_box(1, 1, 1, 3, 5, 5));
    return part.boundary();
}

TEST(IsClosed, KnowsASurfaceFromOneWithAGap) {
    const Boundary whole = notched_block();
    EXPECT_TRUE(is_closed(whole));
    EXPECT_TRUE(is_closed(Boundary{}));
    for (std::size_t f = 0; f < whole.faces.size(); ++f) {
        Boundary gap = whole;
        gap.faces.erase(gap.faces.begin() + static_cast<std::ptrdiff_t>(f));
        EXPECT_FALSE(is_closed(gap));
        Boundary flipped = whole;
        auto& loop = flipped.faces[f].loops[0];
        std::swap(loop[0], loop[1]);
        EXPECT_FALSE(is_closed(flipped));
    }
}

// A tetrahedron of 1000 units at the origin, then without a side.
TEST(Stitch, TellsThatFacesAreMissing) {
    const Plane x{-1, 0, 0, 0};
    const Plane y{0, -1, 0, 0};
    const Plane z{0, 0, -1, 0};
    const Plane far{1, 1, 1, 1000};
    const auto side = [](const Plane& p, const Plane& a, const Plane& b, const Plane& c) {
        return Fragment{
            p, Origin{1}, {{{*meet(p, a, b), b}, {*meet(p, b, c), c}, {*meet(p, c, a), a}}}};
    };
    std::vector<Fragment> sides{side(x, y, far, z), side(y, z, far, x), side(z, x, far, y),
                                side(far, x, y, z)};
    const auto stitched = [&] {
        Stitcher stitcher(kLattice, 1);
        stitcher.add_part(outlines_of(sides));
        return stitcher.finish();
    };
    EXPECT_TRUE(check(stitched()).is_closed());
    sides.pop_back();
    EXPECT_THROW(stitched(), std::logic_error);
}

}  // namespace
}  // namespace ncsim::cda
