// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of the lattice unit and rounding.
#include "ncsim/cda/lattice.h"

namespace ncsim::cda {

Lattice Lattice::for_stock(const Box& stock_mm) {
    double reach = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        reach = std::max({reach, std::abs(stock_mm.min[axis]), std::abs(stock_mm.max[axis])});
    }
    const double limit = static_cast<double>(std::int64_t{1} << kCoordinateBits);
    // Steps 1, 2, 5 times a power of ten; the largest exceeds any representable stock.
    double decade = 1e-5;
    for (int k = 0; k < 300; ++k, decade *= 10.0) {
        for (const double step : {1.0, 2.0, 5.0}) {
            if (reach <= limit * (step * decade)) return {step * decade};
        }
    }
    return {decade};
}

LatticePoint Lattice::round(Vec3 p_mm) const {
    const auto snap = [this](double mm) {
        const double limit = static_cast<double>(kMaxPose);
        return static_cast<std::int64_t>(std::round(std::clamp(mm / unit_mm, -limit, limit)));
    };
    return {snap(p_mm.x), snap(p_mm.y), snap(p_mm.z)};
}

Vec3 Lattice::to_mm(LatticePoint p) const {
    return to_mm(
        Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
}

Vec3 Lattice::to_mm(Vec3 p_units) const {
    if (unit_mm >= 1.0) return unit_mm * p_units;
    const double units_in_mm = std::round(1.0 / unit_mm);
    return {p_units.x / units_in_mm, p_units.y / units_in_mm, p_units.z / units_in_mm};
}

}  // namespace ncsim::cda
