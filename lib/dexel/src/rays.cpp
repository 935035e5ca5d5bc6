// SPDX-License-Identifier: GPL-3.0-or-later
#include "rays.h"

#include <algorithm>
#include <cmath>

namespace ncsim::dexel {

namespace {

constexpr double kFull = 32767.0;

double sign(double x) {
    return x < 0.0 ? -1.0 : 1.0;
}

}  // namespace

PackedNormal PackedNormal::of(cda::Vec3 n) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    double u = n.x / sum, v = n.y / sum;
    if (n.z < 0.0) {
        const double folded = (1.0 - std::abs(v)) * sign(u);
        v = (1.0 - std::abs(u)) * sign(v);
        u = folded;
    }
    return {static_cast<std::int16_t>(std::round(u * kFull)),
            static_cast<std::int16_t>(std::round(v * kFull))};
}

cda::Vec3 PackedNormal::unpacked() const {
    double x = u / kFull, y = v / kFull;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    if (z < 0.0) {
        const double folded = (1.0 - std::abs(y)) * sign(x);
        y = (1.0 - std::abs(x)) * sign(y);
        x = folded;
    }
    return cda::normalized({x, y, z});
}

void Ray::cut_several(const End& low, const End& high) {
    if (low.at >= rest_.back().high.at) return;
    std::vector<Interval> left;
    for_each([&](const Interval& interval) {
        if (high.at <= interval.low.at || low.at >= interval.high.at) {
            left.push_back(interval);
            return;
        }
        if (low.at > interval.low.at) left.push_back({interval.low, low});
        if (high.at < interval.high.at) left.push_back({high, interval.high});
    });
    first_ = left.empty() ? Interval{} : left.front();
    rest_.assign(left.begin() + (left.empty() ? 0 : 1), left.end());
}

bool Ray::contains(double place) const {
    bool is_inside = false;
    for_each([&](const Interval& interval) {
        is_inside |= interval.low.at <= place && place <= interval.high.at;
    });
    return is_inside;
}

std::int64_t Ray::length() const {
    std::int64_t sum = 0;
    for_each(
        [&](const Interval& interval) { sum += std::int64_t{interval.high.at} - interval.low.at; });
    return sum;
}

Rays::Rays(const Grid& grid, std::size_t axis)
    : axis_(axis),
      row_(grid.axes[(axis + 1) % 3].corners()),
      rays_(row_ * grid.axes[(axis + 2) % 3].corners()) {}

double Rays::length() const {
    std::int64_t sum = 0;
    for (const Ray& ray : rays_)
        sum += ray.length();
    return static_cast<double>(sum);
}

}  // namespace ncsim::dexel
