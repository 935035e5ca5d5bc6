// SPDX-License-Identifier: GPL-3.0-or-later
//
// Oriented planes with integer coefficients, the input of the kernel. A cell is a set of
// halfspaces, and a vertex is the intersection of three planes; no other geometry is stored.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace ncsim::cda {

/// The halfspace n·x <= d in lattice units. Canonical: the four numbers have no common divisor, so
/// equal planes are equal values. |n_i| <= 2^kNormalBits, n != 0.
struct Plane {
    std::int32_t nx = 0, ny = 0, nz = 1;
    std::int64_t d = 0;

    constexpr auto operator<=>(const Plane&) const = default;

    /// Returns the same plane with the opposite orientation.
    constexpr Plane opposite() const { return {-nx, -ny, -nz, -d}; }
    constexpr bool is_parallel_to(const Plane& o) const {
        return std::int64_t{nx} * o.ny == std::int64_t{ny} * o.nx &&
               std::int64_t{ny} * o.nz == std::int64_t{nz} * o.ny &&
               std::int64_t{nx} * o.nz == std::int64_t{nz} * o.nx;
    }
};

/// Divides out common divisors. Requires: n != 0 and components within kNormalBits.
Plane canonical(std::int64_t nx, std::int64_t ny, std::int64_t nz, std::int64_t d);

/// Returns the normal as a unit vector.
Vec3 unit_normal(const Plane& plane);
/// Returns the signed distance of the plane from the origin along the normal, mm.
double offset_mm(const Plane& plane, const Lattice& lattice);
/// Returns the signed distance of the plane from `centre` along the normal, both in lattice units.
double distance_about(const Plane& plane, Vec3 centre);

/// Hash of canonical planes, for unordered containers.
struct PlaneHash {
    std::size_t operator()(const Plane& p) const noexcept;
};

}  // namespace ncsim::cda
