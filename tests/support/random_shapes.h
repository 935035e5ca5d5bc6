// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded shapes for tests: identical in each run and on each machine.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/lattice.h"

#include "support/random.h"

#include <cstdint>
#include <vector>

namespace ncsim::test {

inline constexpr cda::Lattice kLattice{1e-5};

inline cda::LatticePoint random_point(Random& random, std::int64_t reach) {
    return {random.between(-reach, reach), random.between(-reach, reach),
            random.between(-reach, reach)};
}

/// Returns a plane through the origin with a non-zero normal whose components have absolute values
/// of at most `size`.
inline cda::Plane random_normal(Random& random, std::int64_t size) {
    cda::Plane plane;
    do {
        plane.nx = static_cast<std::int32_t>(random.between(-size, size));
        plane.ny = static_cast<std::int32_t>(random.between(-size, size));
        plane.nz = static_cast<std::int32_t>(random.between(-size, size));
    } while (plane.nx == 0 && plane.ny == 0 && plane.nz == 0);
    return plane;
}

/// Returns the hull of `points` random points about `centre`, in general position.
inline cda::Cell random_hull(Random& random, cda::LatticePoint centre, std::int64_t reach,
                             int points, cda::Origin origin = cda::kStockOrigin) {
    while (true) {
        std::vector<cda::LatticePoint> cloud;
        for (int i = 0; i < points; ++i)
            cloud.push_back(centre + random_point(random, reach));
        if (auto cell = cda::convex_hull(cloud, kLattice, origin)) return *cell;
    }
}

/// Returns the box with the given corners (mm).
inline cda::Cell mm_box(std::int64_t x0, std::int64_t y0, std::int64_t z0, std::int64_t x1,
                        std::int64_t y1, std::int64_t z1, cda::Origin origin = cda::kStockOrigin) {
    constexpr std::int64_t k = 100000;
    return cda::box_cell({x0 * k, y0 * k, z0 * k}, {x1 * k, y1 * k, z1 * k}, kLattice, origin);
}

/// Sets a rank of 0, 1 or 2 that does not follow the order of the motions. The ranks must not
/// affect the part.
inline cda::Cell ranked(cda::Cell cell) {
    cell.rank = static_cast<std::int32_t>(static_cast<std::uint32_t>(cell.origin) * 5 % 7 % 3);
    return cell;
}

}  // namespace ncsim::test
