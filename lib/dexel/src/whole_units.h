// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places in whole lattice units.
#pragma once

#include "rays.h"

#include <cstdint>

namespace ncsim::dexel {

/// The nearest, away from 0 of two; beyond all of the stock it makes no difference which.
[[gnu::always_inline]] inline std::int32_t whole_units(double place) {
    constexpr double kMost = Gap::kEver;
    const double kept = place < -kMost ? -kMost : place > kMost ? kMost : place;
    return static_cast<std::int32_t>(kept + (kept < 0.0 ? -0.5 : 0.5));
}

}  // namespace ncsim::dexel
