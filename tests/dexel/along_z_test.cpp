// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests models with rays along Z alone, which build a closed surface of their own.
#include "ncsim/cda/check.h"
#include "ncsim/cda/tree.h"
#include "ncsim/dexel/dexel.h"

#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace ncsim::dexel {
namespace {

using cda::Boundary;
using test::kLattice;
using test::mm_box;

std::unique_ptr<cda::WorkpieceModel> block(double resolution, std::size_t threads = 1) {
    return Dexel({threads, resolution, Directions::OnlyZ})
        .create(mm_box(0, 0, 0, 10, 10, 6), kLattice);
}

cda::RoundSweep ball(double radius, Vec3 from, Vec3 to, std::uint32_t motion) {
    cda::RoundSweep sweep;
    sweep.radius = sweep.tip_height = radius;
    sweep.height = 20;
    sweep.from = from;
    sweep.to = to;
    sweep.origin = cda::Origin{motion};
    for (const Vec3& end : {from, to}) {
        sweep.bounds.add(end - Vec3{radius, radius, 0});
        sweep.bounds.add(end + Vec3{radius, radius, sweep.height});
    }
    return sweep;
}

TEST(AlongZ, ABlockIsItself) {
    const auto part = block(0.3);
    EXPECT_NEAR(part->volume(), 600.0, 1e-9);
    EXPECT_EQ(part->volume_error(), 0.0);
    const Boundary boundary = part->boundary();
    EXPECT_TRUE(cda::check(boundary).is_closed());
    EXPECT_EQ(boundary.shells, 1U);
    EXPECT_NEAR(cda::volume(boundary), 600.0, 0.05);
}

// Slopes are as accurate as with rays along all axes.
TEST(AlongZ, ABallLeavesAGrooveOfItsOwnRadius) {
    const auto part = block(0.2);
    dynamic_cast<cda::SweepModel&>(*part).subtract_sweep(ball(2, {-3, 5, 4}, {13, 5, 4}, 1));
    const Boundary boundary = part->boundary();
    EXPECT_TRUE(cda::check(boundary).is_closed());
    EXPECT_NEAR(part->volume(), 600 - 10 * 2 * std::acos(-1.0), 0.4);
    int found = 0;
    for (const Vec3& v : boundary.vertices) {
        if (v.z > 5.5 || v.z < 0.01 || v.x < 0.3 || v.x > 9.7 || v.y < 0.3 || v.y > 9.7) continue;
        // Steep slopes are accurate to half a pitch.
        EXPECT_NEAR(std::hypot(v.y - 5, v.z - 6), 2.0, v.z < 4.8 ? 0.015 : 0.1)
            << v.y << ' ' << v.z;
        ++found;
    }
    EXPECT_GT(found, 500);
}

TEST(AlongZ, AWallIsWithinHalfAPitchAndAPlaneIsFlat) {
    const auto part = block(0.3);
    part->subtract_unmeasured(mm_box(-1, 3, 4, 11, 6, 7, cda::Origin{7}));
    const Boundary boundary = part->boundary();
    EXPECT_TRUE(cda::check(boundary).is_closed());
    EXPECT_LE(std::abs(part->volume() - 540.0), part->volume_error());
    for (const Vec3& v : boundary.vertices) {
        const bool is_wall = v.z > 4.2 && v.z < 5.8 && v.y > 1 && v.y < 9 && v.x > 0.5 && v.x < 9.5;
        if (is_wall) {
            EXPECT_LT(std::min(std::abs(v.y - 3), std::abs(v.y - 6)), 0.16);
        }
        if (v.y > 3.4 && v.y < 5.6 && v.x > 0.5 && v.x < 9.5 && v.z > 1) {
            EXPECT_NEAR(v.z, 4.0, 1e-3);
        }
    }
}

// Cuts include undercuts, because a ray stores every interval on it.
TEST(AlongZ, IsClosedWhateverIsCutAndTheVolumeIsAsNearAsItIsTold) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(4000 + seed);
        const auto part = block(0.5);
        cda::TreeCda exact(mm_box(0, 0, 0, 10, 10, 6), kLattice);
        for (int i = 0; i < 15; ++i) {
            const auto x = static_cast<std::int64_t>(random.next() % 10);
            const auto y = static_cast<std::int64_t>(random.next() % 10);
            const auto z = static_cast<std::int64_t>(random.next() % 6);
            const auto cell = mm_box(x, y, z, x + 1 + static_cast<std::int64_t>(random.next() % 4),
                                     y + 1 + static_cast<std::int64_t>(random.next() % 4), z + 2);
            part->subtract_unmeasured(cell);
            exact.subtract_unmeasured(cell);
        }
        EXPECT_TRUE(cda::check(part->boundary()).is_closed());
        EXPECT_LE(std::abs(part->volume() - exact.volume()), part->volume_error());
    }
}

TEST(AlongZ, DoesNotDependOnThreads) {
    const auto cut = [](std::size_t threads) {
        auto part = block(0.2, threads);
        test::Random random(5);
        const auto somewhere = [&] {
            return Vec3{random.within(0, 10), random.within(0, 10), random.within(2, 6)};
        };
        Vec3 at = somewhere();
        for (std::uint32_t i = 1; i < 3000; ++i) {
            const Vec3 next = at + 0.05 * (somewhere() - at);
            dynamic_cast<cda::SweepModel&>(*part).subtract_sweep(ball(0.5, at, next, i));
            at = next;
        }
        return part;
    };
    const auto one = cut(1);
    const Boundary expected = one->boundary();
    for (const std::size_t threads : {2U, 8U}) {
        const auto many = cut(threads);
        EXPECT_EQ(many->volume(), one->volume());
        EXPECT_EQ(many->boundary().vertices, expected.vertices);
    }
}

// Some sweeps are of a tool with short flutes. With `looks`, the volume is computed after each cut.
TEST(AlongZ, DoesNotDependOnWhatElseWaits) {
    const auto cut = [](bool looks) {
        auto part = block(0.25);
        test::Random random(8);
        const auto somewhere = [&] {
            return Vec3{random.within(0, 10), random.within(0, 10), random.within(1, 6)};
        };
        Vec3 at = somewhere();
        for (std::uint32_t i = 1; i < 600; ++i) {
            const Vec3 next = at + 0.1 * (somewhere() - at);
            cda::RoundSweep sweep = ball(0.5, at, next, i);
            if (i % 100 == 70 || (i > 300 && i % 9 == 0)) sweep.height = 1.0;
            dynamic_cast<cda::SweepModel&>(*part).subtract_sweep(sweep);
            if (looks) part->volume();
            at = next;
        }
        return part;
    };
    const auto together = cut(false), alone = cut(true);
    EXPECT_EQ(together->volume(), alone->volume());
    const Boundary a = together->boundary(), b = alone->boundary();
    EXPECT_EQ(a.vertices, b.vertices);
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t i = 0; i < a.faces.size(); ++i)
        ASSERT_EQ(a.faces[i].origin, b.faces[i].origin) << i;
}

}  // namespace
}  // namespace ncsim::dexel
