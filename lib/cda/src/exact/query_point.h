// SPDX-License-Identifier: GPL-3.0-or-later
//
// A query point in fixed point: sides of planes are decided in integers.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ncsim::cda {

/// A point rounded to 2^-16 of a lattice unit.
struct QueryPoint {
    static constexpr std::int64_t kScale = 65536;  ///< Steps per lattice unit.
    std::array<std::int64_t, 3> at{};

    QueryPoint(Vec3 mm, const Lattice& lattice) {
        constexpr double kReach = 1e12;  // units; beyond any object on the lattice
        for (std::size_t i = 0; i < 3; ++i) {
            const double units = mm[static_cast<int>(i)] / lattice.unit_mm;
            at[i] = static_cast<std::int64_t>(
                std::round(std::clamp(units, -kReach, kReach) * static_cast<double>(kScale)));
        }
    }
    Side side_of(const Plane& p) const {
        const Int128 v = static_cast<Int128>(p.nx) * at[0] + static_cast<Int128>(p.ny) * at[1] +
                         static_cast<Int128>(p.nz) * at[2] - static_cast<Int128>(p.d) * kScale;
        return v > 0 ? Side::Above : v < 0 ? Side::Below : Side::On;
    }
};

}  // namespace ncsim::cda
