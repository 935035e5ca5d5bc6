// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names for exact things: keys for lines.
#pragma once

#include "ncsim/cda/predicates.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace ncsim::cda {

/// The line where two planes meet, by its Plücker coordinates up to a factor: direction n_s × n_t,
/// the first component that is not zero positive, and moment d_s n_t − d_t n_s. Requires planes
/// that are not parallel.
struct Pluecker {
    Pluecker(const Plane& s, const Plane& t);
    std::array<std::int64_t, 3> d{};  ///< 50 bits.
    std::array<Int128, 3> m{};        ///< 78 bits.

    /// Equal for equal lines, whichever planes meet in them.
    std::uint64_t hash() const;
};

/// Exactly.
bool are_same(const Pluecker& a, const Pluecker& b);

/// The axis along which a direction is longest; the first of several.
inline std::size_t longest(const std::array<std::int64_t, 3>& d) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
    }
    return axis;
}

}  // namespace ncsim::cda
