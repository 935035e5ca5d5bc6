// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the rays.
#include "grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ncsim::dexel {

GridAxis::GridAxis(double min, double max, double wanted) {
    const double count = std::max(1.0, std::ceil((max - min) / std::max(2.0, wanted) - 1e-9));
    if (!(count < kMostRays)) throw std::invalid_argument("the resolution is too fine");
    pitch = (max - min) / count;
    const auto n = static_cast<std::size_t>(count);
    at.reserve(n + 2);
    for (std::size_t i = 0; i < n + 2; ++i)
        at.push_back(std::floor(min + (static_cast<double>(i) - 0.5) * pitch) + 0.5);
    // Needed for stock thinner than the smallest pitch.
    at.front() = std::min(at.front(), min - 0.5);
    at.back() = std::max(at.back(), max + 0.5);
}

std::size_t GridAxis::from(double place) const {
    const double guess = (place - at.front()) / pitch;
    auto i = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(at.size())));
    while (i < at.size() && at[i] < place)
        ++i;
    while (i > 0 && at[i - 1] >= place)
        --i;
    return i;
}

Grid::Grid(Vec3 min, Vec3 max, double pitch)
    : axes{GridAxis(min.x, max.x, pitch), GridAxis(min.y, max.y, pitch),
           GridAxis(min.z, max.z, pitch)} {
    const auto corners = [this](std::size_t axis) {
        return static_cast<double>(axes[axis].corners());
    };
    const double rays = corners(0) * corners(1) + corners(1) * corners(2) + corners(2) * corners(0);
    if (!(rays <= kMostRays)) throw std::invalid_argument("the resolution is too fine");
}

GridBox::GridBox(const Box& bounds, const cda::Lattice& lattice, const Grid& grid) {
    constexpr double kRoom = 2.0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        low[a] = bounds.min[axis] / lattice.unit_mm - kRoom;
        high[a] = bounds.max[axis] / lattice.unit_mm + kRoom;
        begin[a] = grid.axes[a].from(low[a]);
        end[a] = grid.axes[a].from(high[a]);
    }
}

}  // namespace ncsim::dexel
