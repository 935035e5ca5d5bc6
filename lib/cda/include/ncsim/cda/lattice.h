// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lattice on which planes and poses lie: integers from here on, so that every later
// decision can be exact.
#pragma once

#include "ncsim/cda/vec.h"

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
/// the intersection of three planes; these two numbers bound every integer in
/// predicates.h, where a static_assert adds them up.
inline constexpr int kCoordinateBits = 25;
inline constexpr int kNormalBits = 24;

/// Farthest from the origin that a pose may lie, in units (a kilometre at 10 nm is 2^37): beyond it
/// n·t would leave 64 bits.
inline constexpr std::int64_t kMaxPose = std::int64_t{1} << 37;

struct Lattice {
    /// Length of one unit in mm: 1e-5 (10 nm) times 1, 2, 5, 10, 20, 50 … so that the
    /// micrometres of NC programs stay exact as long as possible.
    double unit_mm = 1e-5;

    bool operator==(const Lattice&) const = default;

    /// The finest lattice on which all of `stock` has coordinates of kCoordinateBits.
    static Lattice for_stock(const Box& stock_mm);

    /// The nearest lattice point; halves away from zero. Off by at most half a unit an axis.
    /// Coordinates beyond kMaxPose are clamped to it.
    LatticePoint round(Vec3 p_mm) const;
    Vec3 to_mm(LatticePoint p) const;
    /// The same for points between lattice points. Divides by the units in a millimetre, a whole
    /// number for units below one: what was a round number of millimetres stays one.
    Vec3 to_mm(Vec3 p_units) const;
    double cubic_unit_mm3() const { return unit_mm * unit_mm * unit_mm; }
};

}  // namespace ncsim::cda
