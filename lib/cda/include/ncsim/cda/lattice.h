// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lattice of integer points on which planes and poses lie. Decisions about lattice points and
// planes are exact.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>

namespace ncsim::cda {

/// A point or a vector in lattice units.
struct LatticePoint {
    std::int64_t x = 0, y = 0, z = 0;

    constexpr auto operator<=>(const LatticePoint&) const = default;
    constexpr LatticePoint operator-() const { return {-x, -y, -z}; }
    friend constexpr LatticePoint operator+(LatticePoint a, LatticePoint b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr LatticePoint operator-(LatticePoint a, LatticePoint b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
};

/// Bits of a stock coordinate (without sign) and of a component of a plane's normal. A vertex is
/// the intersection of three planes, so the two numbers bound every integer in predicates.h, where
/// a static_assert adds the bits up.
inline constexpr int kCoordinateBits = 25;
inline constexpr int kNormalBits = 24;

/// Largest coordinate of a pose, in units (a kilometre at 10 nm is 2^37). Beyond this value n·t
/// would exceed 64 bits.
inline constexpr std::int64_t kMaxPose = std::int64_t{1} << 37;

/// The lattice of a workpiece: integer points, scaled by a unit length.
struct Lattice {
    /// Length of one unit in mm: 1e-5 (10 nm) times 1, 2, 5, 10, 20, 50 … With these steps the
    /// micrometres of NC programs stay exact as long as possible.
    double unit_mm = 1e-5;

    bool operator==(const Lattice&) const = default;

    /// Returns the finest lattice on which all coordinates of `stock_mm` fit kCoordinateBits.
    static Lattice for_stock(const Box& stock_mm);

    /// Returns the nearest lattice point; halves round away from zero. The error is at most half a
    /// unit per axis. Coordinates beyond kMaxPose are clamped to kMaxPose.
    LatticePoint round(Vec3 p_mm) const;
    Vec3 to_mm(LatticePoint p) const;
    /// Converts points between lattice points as well. If a unit is at most 1 mm, divides by the
    /// number of units per millimetre, an integer, so that whole millimetres stay whole.
    Vec3 to_mm(Vec3 p_units) const;
    double cubic_unit_mm3() const { return unit_mm * unit_mm * unit_mm; }
};

}  // namespace ncsim::cda
