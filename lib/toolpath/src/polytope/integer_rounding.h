// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding of lengths in lattice units to integers.
#pragma once

#include <cmath>
#include <cstdint>

namespace ncsim::toolpath {

/// Tolerance of the rounding: numbers that are integers except for the rounding of a division or a
/// sine keep their value.
inline constexpr double kIntegerGuard = 1e-7;
inline std::int64_t round_up(double v) {
    return static_cast<std::int64_t>(std::ceil(v - kIntegerGuard));
}
inline std::int64_t round_down(double v) {
    return static_cast<std::int64_t>(std::floor(v + kIntegerGuard));
}

}  // namespace ncsim::toolpath
