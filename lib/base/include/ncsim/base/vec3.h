// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors and boxes of doubles: millimetres in the workpiece frame, right-handed, unless the name
// states otherwise.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim {

/// A vector or a point.
struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;

    constexpr bool operator==(const Vec3&) const = default;
    constexpr Vec3 operator-() const { return {-x, -y, -z}; }
    constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) {
    return std::sqrt(dot(a, a));
}
/// Returns the vector scaled to length 1; the zero vector stays zero.
inline Vec3 normalized(Vec3 a) {
    const double length = norm(a);
    return length > 0.0 ? (1.0 / length) * a : a;
}

/// An axis-parallel box; empty if a minimum exceeds the maximum, as in a new box.
struct Box {
    static constexpr double kInf = std::numeric_limits<double>::infinity();
    Vec3 min{kInf, kInf, kInf};
    Vec3 max{-kInf, -kInf, -kInf};

    constexpr bool operator==(const Box&) const = default;
    constexpr bool is_empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    constexpr Vec3 size() const { return is_empty() ? Vec3{} : max - min; }
    constexpr Vec3 centre() const { return 0.5 * (min + max); }

    void add(Vec3 p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
    void add(const Box& b) {
        if (!b.is_empty()) add(b.min), add(b.max);
    }
    /// True if the closed boxes have a common point; touching counts as overlapping.
    constexpr bool overlaps(const Box& b) const {
        return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y &&
               min.z <= b.max.z && b.min.z <= max.z;
    }
    constexpr bool contains(Vec3 p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z &&
               p.z <= max.z;
    }
};

}  // namespace ncsim
