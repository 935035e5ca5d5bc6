// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interpolation over a triangle.
#include "render/surface.h"

#include <algorithm>

namespace ncsim::exporter {

CornerShares::CornerShares(const std::array<Vec3, 3>& corners_C) : corner_(corners_C[0]) {
    const Vec3 second = corners_C[1] - corner_, third = corners_C[2] - corner_;
    const Vec3 area = cross(second, third);
    const double square = dot(area, area);
    // A triangle without area is not visible.
    if (!(square > 0.0)) return;
    to_second_ = (1.0 / square) * cross(third, area);
    to_third_ = (1.0 / square) * cross(area, second);
}

std::pair<double, double> CornerShares::at(Vec3 p_C) const {
    const Vec3 p = p_C - corner_;
    // Samples at the edge of a needle can lie outside by many times its width.
    const double second = std::clamp(dot(to_second_, p), 0.0, 1.0);
    return {second, std::clamp(dot(to_third_, p), 0.0, 1.0 - second)};
}

Bend::Bend(const std::array<Vec3, 3>& corners_C, const std::array<Vec3, 3>& n_C)
    : shares_(corners_C),
      n_(n_C[0]),
      towards_second_(n_C[1] - n_C[0]),
      towards_third_(n_C[2] - n_C[0]) {}

Vec3 Bend::normal_at(Vec3 p_C) const {
    const auto [second, third] = shares_.at(p_C);
    const Vec3 n = n_ + second * towards_second_ + third * towards_third_;
    // The point is a corner without a normal.
    return normalized(n == Vec3{} ? 2.0 * n_ + towards_second_ : n);
}

double Ramp::value_at(Vec3 p_C) const {
    const auto [second, third] = shares_.at(p_C);
    return values_[0] + second * (values_[1] - values_[0]) + third * (values_[2] - values_[0]);
}

}  // namespace ncsim::exporter
