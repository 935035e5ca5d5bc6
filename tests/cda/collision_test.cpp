// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests collisions of a part with convex and concave bodies.
#include "ncsim/cda/collision.h"

#include "ncsim/cda/triangulate.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;

// Returns the surface of `block` minus the boxes `less`: a closed mesh of any shape.
TriangleMesh mesh_of(const Cell& block, const std::vector<Cell>& less) {
    FlatCda body(block, kLattice);
    for (const Cell& cell : less)
        body.subtract(cell);
    return triangulate(body.boundary());
}

// Returns a bridge with feet at x 0–1 and 3–4 and an opening 2 mm high.
TriangleMesh bridge(std::int64_t z) {
    return mesh_of(mm_box(0, 0, z, 4, 4, z + 3), {mm_box(1, -1, z - 1, 3, 5, z + 2)});
}

FlatCda block_with_rib() {
    // A plate at z 0–1 with a rib at x 1–3, 2 mm high.
    FlatCda part(mm_box(0, 0, 0, 4, 4, 3), kLattice);
    part.subtract(mm_box(-1, -1, 1, 1, 5, 4, Origin{1}));
    part.subtract(mm_box(3, -1, 1, 5, 5, 4, Origin{2}));
    return part;
}

TEST(Collision, NeedsMaterialNotOnlyMilledSpace) {
    FlatCda part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    part.subtract(mm_box(1, 1, 2, 3, 3, 5, Origin{1}));
    EXPECT_FALSE(collision(part, mm_box(1, 1, 2, 3, 3, 9)));  // fills the pocket exactly
    EXPECT_FALSE(collision(part, mm_box(4, 0, 0, 9, 4, 4)));  // touches a side
    EXPECT_FALSE(collision(part, mm_box(10, 0, 0, 11, 4, 4)));
}

TEST(Collision, OfABodyInBothMilledSpaceAndMaterialIsSeen) {
    // The rule "no negative cell may meet the body" misses this collision.
    FlatCda part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    part.subtract(mm_box(1, 1, 2, 3, 3, 5, Origin{1}));
    const auto hit = collision(part, mm_box(1, 1, 1, 3, 3, 9));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(part.contains(*hit));
    EXPECT_TRUE((Box{{1, 1, 1}, {3, 3, 2}}.contains(*hit)));
}

TEST(Collision, OfAConcaveBodyIsNotThatOfItsHull) {
    const FlatCda part = block_with_rib();
    ASSERT_TRUE(collision(part, mm_box(0, 0, 1, 4, 4, 4)));  // the hull meets the rib
    EXPECT_FALSE(collision(part, bridge(1)));                // the bridge spans the rib, touching
    EXPECT_FALSE(collision(part, bridge(5)));
}

TEST(Collision, OfAConcaveBodyHasACertificateInTheMaterial) {
    const FlatCda part = block_with_rib();
    const auto hit =
        collision(part, mesh_of(mm_box(0, 0, 1, 4, 4, 4), {mm_box(1, -1, 0, 2, 5, 3)}));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(part.contains(*hit));
    EXPECT_TRUE((Box{{2, 0, 1}, {3, 4, 3}}.contains(*hit)));
}

TEST(Collision, OfAPieceOfMaterialInsideTheBodyIsToldByARay) {
    // The part lies within the body, so no surface of the body passes through the part.
    const FlatCda part(mm_box(1, 1, 1, 2, 2, 2), kLattice);
    EXPECT_TRUE(collision(part, mesh_of(mm_box(0, 0, 0, 4, 4, 4), {})));
    // The same body with a cavity around the part.
    EXPECT_FALSE(collision(part, mesh_of(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 1, 1, 3, 3, 3)})));
}

TEST(Collision, OfAFlatBodyIsNone) {
    const FlatCda part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    TriangleMesh sheet;
    sheet.vertices = {{1, 1, 1}, {3, 1, 1}, {1, 3, 1}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_FALSE(collision(part, sheet));
}

}  // namespace
}  // namespace ncsim::cda
