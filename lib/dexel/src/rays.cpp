// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals of rays and packed normals.
#include "rays.h"

#include <algorithm>
#include <cmath>

namespace ncsim::dexel {

namespace {

double sign(double x) {
    return x < 0.0 ? -1.0 : 1.0;
}

}  // namespace

Vec3 PackedNormal::unpacked() const {
    double x = u / kFull, y = v / kFull;
    const double z = 1.0 - std::abs(x) - std::abs(y);
    if (z < 0.0) {
        const double folded = (1.0 - std::abs(y)) * sign(x);
        y = (1.0 - std::abs(x)) * sign(y);
        x = folded;
    }
    return normalized({x, y, z});
}

Ray::Ray(const Ray& other)
    : single_(other.single_),
      list_(other.list_ ? std::make_unique<std::vector<Interval>>(*other.list_) : nullptr) {}

Ray& Ray::operator=(const Ray& other) {
    *this = Ray(other);
    return *this;
}

void Ray::set(const Interval& interval) {
    single_ = interval;
    list_ = nullptr;
}

void Ray::split(std::size_t at, const Interval& below, const Interval& above) {
    if (!list_) {
        list_ = std::make_unique<std::vector<Interval>>();
        list_->push_back(single_);
    }
    (*list_)[at] = below;
    list_->insert(list_->begin() + static_cast<std::ptrdiff_t>(at) + 1, above);
}

void Ray::erase(std::size_t begin, std::size_t end) {
    if (!list_) {
        single_ = {};
        return;
    }
    const auto from = list_->begin();
    list_->erase(from + static_cast<std::ptrdiff_t>(begin),
                 from + static_cast<std::ptrdiff_t>(end));
}

bool Ray::contains(double place) const {
    return std::ranges::any_of(intervals(), [&](const Interval& interval) {
        return interval.low.at <= place && place <= interval.high.at;
    });
}

std::int64_t Ray::length() const {
    std::int64_t sum = 0;
    for (const Interval& interval : intervals())
        sum += std::int64_t{interval.high.at} - interval.low.at;
    return sum;
}

std::size_t Ray::bytes() const {
    return list_ ? sizeof(std::vector<Interval>) + list_->capacity() * sizeof(Interval) : 0;
}

Rays::Rays(const Grid& grid, std::size_t axis)
    : axis_(axis),
      row_(grid.axes[(axis + 1) % 3].corners()),
      rays_(row_ * grid.axes[(axis + 2) % 3].corners()),
      gaps_(rays_.size()) {
    const auto blocks = [](std::size_t count) { return (count + kBlock - 1) / kBlock; };
    blocks_ = blocks(row_);
    ceilings_.assign(blocks_ * blocks(rows()), Gap::kUnbounded);
}

double Rays::length() const {
    std::int64_t sum = 0;
    for (const Ray& ray : rays_)
        sum += ray.length();
    return static_cast<double>(sum);
}

std::size_t Rays::bytes() const {
    std::size_t sum = rays_.capacity() * sizeof(Ray) + gaps_.capacity() * sizeof(Gap) +
                      ceilings_.capacity() * sizeof(std::int32_t);
    for (const Ray& ray : rays_)
        sum += ray.bytes();
    return sum;
}

}  // namespace ncsim::dexel
