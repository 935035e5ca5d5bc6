// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of few boxes against designs of few boxes, with results that are known by hand calculation.
#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/verify/design_comparison.h"

#include "common_volume.h"

#include <gtest/gtest.h>

#include <random>

namespace ncsim::verify_test {
namespace {

using verify::compare;

const cda::Lattice kLattice;
constexpr double kTolerance = 0.05;

cda::Cell box(Vec3 min, Vec3 max, std::uint32_t origin = 0) {
    return cda::box_cell(kLattice.round(min), kLattice.round(max), kLattice, cda::Origin{origin});
}

// Returns a block of 40 x 30 x 10 mm with its top at Z0, minus `boxes`.
cda::TreeCda block_less(const std::vector<cda::Cell>& boxes) {
    cda::TreeCda part(box({-20, -15, -10}, {20, 15, 0}), kLattice);
    for (const cda::Cell& cell : boxes)
        part.subtract_unmeasured(cell);
    return part;
}

TriangleMesh mesh_of(const cda::TreeCda& part) {
    return cda::triangulate(part.boundary());
}

const cda::Cell kSlot = box({-21, -5, -2}, {21, 5, 1}, 7);

TEST(Design, OfThePartItselfHasNothingBeyondIt) {
    const cda::TreeCda part = block_less({kSlot});
    const auto c = compare(part.boundary(), mesh_of(part), kTolerance);
    EXPECT_TRUE(c.gouge.regions.empty());
    EXPECT_TRUE(c.excess.regions.empty());
    EXPECT_EQ(c.deviation_mm, 0.0);
    EXPECT_NEAR(c.gouge.volume_mm3.value(), 0.0, 1e-6);
    EXPECT_NEAR(c.excess.volume_mm3.value(), 0.0, 1e-6);
    EXPECT_EQ(c.resolution_mm, kTolerance / 8);
}

TEST(Design, WithADeeperPocketShowsTheExcessAtItsPlace) {
    const auto part = block_less({kSlot, box({-18, 8, -3}, {-10, 12, 1}, 3)});
    const auto design = block_less({kSlot, box({-18, 8, -3.1}, {-10, 12, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    EXPECT_TRUE(c.gouge.regions.empty());
    ASSERT_EQ(c.excess.regions.size(), 1U);
    const auto& region = c.excess.regions.front();
    EXPECT_NEAR(region.depth_mm, 0.1, 1e-9);
    EXPECT_EQ(region.origin, cda::Origin{3});
    EXPECT_GE(region.box.min.x, -18.0);
    EXPECT_LE(region.box.max.x, -10.0);
    EXPECT_GE(region.box.min.y, 8.0);
    EXPECT_GE(region.point.z, -3.1 - 1e-9);
    EXPECT_LE(region.point.z, -3.0 + 1e-9);
    EXPECT_NEAR(c.excess.volume_mm3.value(), 8 * 4 * 0.1, 1e-6);
    EXPECT_NEAR(c.gouge.volume_mm3.value(), 0.0, 1e-6);
}

TEST(Design, WithAShallowerPocketShowsTheGougeAndWhoCutIt) {
    const auto part = block_less({kSlot, box({-18, 8, -3.1}, {-10, 12, 1}, 3)});
    const auto design = block_less({kSlot, box({-18, 8, -3}, {-10, 12, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    EXPECT_TRUE(c.excess.regions.empty());
    ASSERT_EQ(c.gouge.regions.size(), 1U);
    EXPECT_NEAR(c.gouge.regions.front().depth_mm, 0.1, 1e-9);
    EXPECT_EQ(c.gouge.regions.front().origins, std::vector{cda::Origin{3}});
    EXPECT_NEAR(c.gouge.volume_mm3.value(), 8 * 4 * 0.1, 1e-6);
    EXPECT_NEAR(c.deviation_mm, 0.1, 1e-9);
}

// The depth of missing material in a wall is half the thickness, because both sides are surface;
// the wall is 2 mm high.
TEST(Design, TellsHowFarBelowItsSurfaceSomethingIsMissing) {
    const cda::Cell left = box({-21, -12, -2}, {21, 0, 1}, 3),
                    right = box({-21, 0.1, -2}, {21, 12, 1}, 4);
    const auto part = block_less({box({-21, -12, -2}, {21, 12, 1}, 3)});
    const auto design = block_less({left, right});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    ASSERT_EQ(c.gouge.regions.size(), 1U);
    EXPECT_NEAR(c.gouge.regions.front().depth_mm, 2.0, 0.05);
    EXPECT_LE(c.gouge.regions.front().below_mm, 0.05 + 1e-9);
    EXPECT_GE(c.gouge.regions.front().below_mm, 0.035);
    const auto deep = block_less({box({-21, -12, -2.5}, {21, 12, 1}, 3)});
    const auto shallow = block_less({box({-21, -12, -2}, {21, 12, 1}, 3)});
    const auto flat = compare(deep.boundary(), mesh_of(shallow), kTolerance);
    ASSERT_EQ(flat.gouge.regions.size(), 1U);
    EXPECT_NEAR(flat.gouge.regions.front().below_mm, 0.5, 1e-9);
    // The same for excess material: a thin wall, and a shallow pocket.
    const auto left_over = compare(design.boundary(), mesh_of(part), kTolerance);
    ASSERT_EQ(left_over.excess.regions.size(), 1U);
    EXPECT_NEAR(left_over.excess.regions.front().depth_mm, 2.0, 0.05);
    EXPECT_LE(left_over.excess.regions.front().below_mm, 0.05 + 1e-9);
    EXPECT_GE(left_over.excess.regions.front().below_mm, 0.035);
    const auto high = compare(shallow.boundary(), mesh_of(deep), kTolerance);
    ASSERT_EQ(high.excess.regions.size(), 1U);
    EXPECT_NEAR(high.excess.regions.front().below_mm, 0.5, 1e-9);
}

TEST(Design, WithinTheToleranceIsKept) {
    const auto part = block_less({kSlot});
    const auto design = block_less({box({-21, -5.03, -2.03}, {21, 4.97, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    EXPECT_TRUE(c.gouge.regions.empty());
    EXPECT_TRUE(c.excess.regions.empty());
    EXPECT_GT(c.deviation_mm, 0.02);
    EXPECT_GT(c.gouge.volume_mm3.value(), 0.0) << "what lies within the tolerance is counted";
}

TEST(Design, FindsWhatNoCornerTells) {
    // A needle of 0.2 x 0.2 mm in the middle of a wide floor, far from all corners of the part.
    const auto part = block_less({});
    const auto design = block_less({box({3.1, 2.3, -4}, {3.3, 2.5, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    ASSERT_EQ(c.excess.regions.size(), 1U);
    // The top face is nearest to the deepest point; the walls of the hole are not.
    EXPECT_NEAR(c.excess.regions.front().depth_mm, 4.0, 1e-9);
    EXPECT_EQ(c.excess.regions.front().origin, cda::kStockOrigin);
    EXPECT_NEAR(c.excess.volume_mm3.value(), 0.16, 1e-6);
}

TEST(Design, MeasuresAMissingRibByItsHeight) {
    const auto part = block_less({box({-15, -10, -6}, {15, 10, 1}, 5)});
    const auto design =
        block_less({box({-15, -10, -6}, {-0.5, 10, 1}), box({0.5, -10, -6}, {15, 10, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    ASSERT_EQ(c.gouge.regions.size(), 1U);
    EXPECT_NEAR(c.gouge.regions.front().depth_mm, 6.0, 1e-9);
    EXPECT_EQ(c.gouge.regions.front().origin, cda::Origin{5});
    EXPECT_NEAR(c.gouge.volume_mm3.value(), 1 * 20 * 6, 1e-6);
}

TEST(Design, TellsPlacesApartTheDeepestFirst) {
    const auto part = block_less({});
    const auto design =
        block_less({box({-18, -12, -1}, {-12, -6, 1}), box({8, 5, -3}, {16, 12, 1})});
    const auto c = compare(part.boundary(), mesh_of(design), kTolerance);
    ASSERT_EQ(c.excess.regions.size(), 2U);
    EXPECT_NEAR(c.excess.regions[0].depth_mm, 3.0, 0.07);
    EXPECT_NEAR(c.excess.regions[1].depth_mm, 1.0, 1e-9);
    EXPECT_GT(c.excess.regions[0].box.min.x, 7.9);
    EXPECT_LT(c.excess.regions[1].box.max.x, -11.9);
}

// --- Common volume ------------------------------------------------------------------------------

TEST(CommonVolume, IsThatOfTheAggregateWithAllCuts) {
    // Boxes on a grid, so faces, edges and corners coincide often.
    std::mt19937 random(20011);
    const auto coordinate = [&](double low, int steps) {
        return low + static_cast<double>(random() % static_cast<unsigned>(steps));
    };
    for (int round = 0; round < 100; ++round) {
        SCOPED_TRACE(round);
        cda::TreeCda a = block_less({}), b = block_less({}), both = block_less({});
        for (int i = 0; i < 6; ++i) {
            const Vec3 low{coordinate(-21, 36), coordinate(-16, 26), coordinate(-11, 10)};
            const Vec3 size{coordinate(1, 20), coordinate(1, 15), coordinate(1, 8)};
            const cda::Cell cell = box(low, low + size, static_cast<std::uint32_t>(i + 1));
            (i % 2 == 0 ? a : b).subtract_unmeasured(cell);
            both.subtract_unmeasured(cell);
        }
        const auto volume = verify::common_volume(mesh_of(a), mesh_of(b));
        ASSERT_TRUE(volume.has_value());
        EXPECT_NEAR(*volume, both.volume(), 1e-5);
    }
}

TEST(CommonVolume, IsNothingForBodiesThatTouchAndAllForTheSame) {
    const auto mesh = [](Vec3 min, Vec3 max) {
        return mesh_of(cda::TreeCda(box(min, max), kLattice));
    };
    const auto cube = mesh({0, 0, 0}, {10, 10, 10});
    EXPECT_NEAR(verify::common_volume(cube, cube).value(), 1000.0, 1e-6);
    EXPECT_NEAR(verify::common_volume(cube, mesh({10, 0, 0}, {20, 10, 10})).value(), 0.0, 1e-6);
    EXPECT_NEAR(verify::common_volume(cube, mesh({30, 0, 0}, {40, 10, 10})).value(), 0.0, 1e-9);
    EXPECT_NEAR(verify::common_volume(cube, mesh({2, 3, 4}, {5, 6, 7})).value(), 27.0, 1e-9);
    EXPECT_NEAR(verify::common_volume(mesh({2, 3, 4}, {5, 6, 7}), cube).value(), 27.0, 1e-9);
    EXPECT_EQ(verify::common_volume(cube, {}), 0.0);
}

TEST(TriangleTree, KnowsWhatIsInsideAndHowFarItIs) {
    const auto part = block_less({kSlot, box({-10, -3, -8}, {10, 3, -4})});  // and a cavity
    const TriangleMesh mesh = mesh_of(part);
    const TriangleTree tree(mesh);
    std::mt19937 random(1997);
    std::uniform_real_distribution<double> along(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p{-22 + 44 * along(random), -17 + 34 * along(random), -12 + 14 * along(random)};
        EXPECT_EQ(tree.contains(p), part.contains(p)) << p.x << ' ' << p.y << ' ' << p.z;
        double least = Box::kInf;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            least = std::min(least, distance(p, corners_of(mesh, t)));
        EXPECT_NEAR(tree.nearest(p).distance_mm, least, 1e-12);
    }
    // Directly above corners and edges.
    EXPECT_FALSE(tree.contains({-20, -15, 1}));
    EXPECT_TRUE(tree.contains({0, 0, -3}));
    EXPECT_FALSE(tree.contains({0, 0, -5}));
}

}  // namespace
}  // namespace ncsim::verify_test
