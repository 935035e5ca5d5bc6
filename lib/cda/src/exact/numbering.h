// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of lines for hash tables.
#pragma once

#include "ncsim/cda/predicates.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace ncsim::cda {

/// The line of intersection of two planes in Plücker coordinates up to a factor: direction n_s ×
/// n_t with the first non-zero component positive, and moment d_s n_t − d_t n_s.
/// Requires: the planes are not parallel.
struct Pluecker {
    Pluecker(const Plane& s, const Plane& t);
    std::array<std::int64_t, 3> d{};  ///< 50 bits.
    std::array<Int128, 3> m{};        ///< 78 bits.

    /// Returns equal values for equal lines, independent of the two planes.
    std::uint64_t hash() const;
};

/// Decides exactly if two lines are equal.
bool are_same(const Pluecker& a, const Pluecker& b);

/// Returns the axis along which a direction is longest; the first among equals.
inline std::size_t longest(const std::array<std::int64_t, 3>& d) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
    }
    return axis;
}

}  // namespace ncsim::cda
