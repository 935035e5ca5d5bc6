// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding to integer lattice units.
#pragma once

#include "rays.h"

#include <cstdint>

namespace ncsim::dexel {

/// Returns the nearest integer; halves round away from 0. Values are clamped to ±Gap::kUnbounded,
/// which is beyond the stock.
[[gnu::always_inline]] inline std::int32_t whole_units(double place) {
    constexpr double kMost = Gap::kUnbounded;
    const double kept = place < -kMost ? -kMost : place > kMost ? kMost : place;
    return static_cast<std::int32_t>(kept + (kept < 0.0 ? -0.5 : 0.5));
}

}  // namespace ncsim::dexel
