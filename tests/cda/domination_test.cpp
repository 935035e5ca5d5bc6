// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares implications between planes or cells within a box with points of the box.
#include "tree/domination.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace ncsim::cda {
namespace {

using test::Random;

constexpr std::int64_t kReach = 1 << 20;
const HalfBox kBox{{-2 * kReach + 1, -2 * kReach + 1, -2 * kReach + 1},
                   {2 * kReach - 1, 2 * kReach - 1, 2 * kReach - 1}};

// Returns a plane that cuts the box. Few directions occur, so some planes are parallel.
Plane random_plane(Random& random) {
    const Plane n = test::random_normal(random, random.one_in(2) ? 2 : 1000);
    const std::int64_t size = std::abs(n.nx) + std::abs(n.ny) + std::abs(n.nz);
    return canonical(n.nx, n.ny, n.nz, random.between(-size * kReach + size, size * kReach - size));
}

LatticePoint random_point(Random& random) {
    return test::random_point(random, kReach - 1);
}

bool is_below(const LatticePoint& p, const Plane& plane) {
    return plane.nx * p.x + plane.ny * p.y + plane.nz * p.z <= plane.d;
}

struct Planes {
    std::vector<Plane> exact;
    std::vector<BoxPlane> seen;
};

Planes random_planes(Random& random, std::size_t count) {
    Planes planes;
    for (std::size_t i = 0; i < count; ++i)
        planes.exact.push_back(random_plane(random));
    const BoxFrame frame(kBox);
    for (const Plane& plane : planes.exact)
        planes.seen.emplace_back(HalfPlane(plane), plane, frame);
    return planes;
}

TEST(Implies, NeverClaimsWhatAPointOfTheBoxDenies) {
    Random random(71);
    int strict = 0;
    for (int i = 0; i < 20000; ++i) {
        const Planes p = random_planes(random, 2);
        const Domination found = implies(p.seen[0], p.seen[1]);
        EXPECT_NE(found == Domination::Coplanar, p.exact[0] != p.exact[1]);
        if (found == Domination::None) continue;
        ++strict;
        for (int k = 0; k < 20; ++k) {
            const LatticePoint at = random_point(random);
            if (is_below(at, p.exact[0])) {
                ASSERT_TRUE(is_below(at, p.exact[1]));
            }
        }
    }
    EXPECT_GT(strict, 500);
}

TEST(Implies, SeesParallelPlanesAsTheyAre) {
    const BoxFrame frame(kBox);
    const Plane low{1, 2, 2, 100};
    const Plane high{1, 2, 2, 101};
    const BoxPlane a(HalfPlane(low), low, frame);
    const BoxPlane b(HalfPlane(high), high, frame);
    EXPECT_EQ(implies(a, b), Domination::Strict);
    EXPECT_EQ(implies(b, a), Domination::None);
    EXPECT_EQ(implies(a, a), Domination::Coplanar);
    const Plane back = low.opposite();
    EXPECT_EQ(implies(a, BoxPlane(HalfPlane(back), back, frame)), Domination::None);
}

TEST(Implies, SeesWhatHoldsInTheBoxAlone) {
    // Within the box, and only there, x < -reach/2 implies x + y/8 < 0.
    const BoxFrame frame(kBox);
    const Plane m{1, 0, 0, -kReach / 2};
    const Plane p{8, 1, 0, 0};
    EXPECT_EQ(implies(BoxPlane(HalfPlane(m), m, frame), BoxPlane(HalfPlane(p), p, frame)),
              Domination::Strict);
    const Plane steep{1, 1, 0, 0};
    EXPECT_EQ(implies(BoxPlane(HalfPlane(m), m, frame), BoxPlane(HalfPlane(steep), steep, frame)),
              Domination::None);
}

TEST(Dominated, CellsLieWithinTheOther) {
    Random random(72);
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
        const Planes cell = random_planes(random, 4);
        const Planes by = random_planes(random, static_cast<std::size_t>(random.between(1, 2)));
        if (dominated(cell.seen, by.seen) == Domination::None) continue;
        ++found;
        for (int k = 0; k < 20; ++k) {
            const LatticePoint at = random_point(random);
            const auto in = [&](const std::vector<Plane>& planes) {
                return std::ranges::all_of(planes, [&](const Plane& p) { return is_below(at, p); });
            };
            if (in(cell.exact)) {
                ASSERT_TRUE(in(by.exact));
            }
        }
    }
    EXPECT_GT(found, 500);
    const Planes some = random_planes(random, 5);
    EXPECT_EQ(dominated(some.seen, some.seen), Domination::Coplanar);
}

}  // namespace
}  // namespace ncsim::cda
