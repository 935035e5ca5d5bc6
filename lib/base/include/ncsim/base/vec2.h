// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors in a plane.
#pragma once

#include <cmath>
#include <cstddef>

namespace ncsim {

/// A vector or a point of a plane, in any unit.
struct Vec2 {
    double x = 0.0, y = 0.0;

    constexpr bool operator==(const Vec2&) const = default;
    constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : y; }
    constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : y; }
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
};

constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// Returns the cross product: positive if `b` points to the left of `a`.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
inline double norm(Vec2 a) {
    return std::sqrt(dot(a, a));
}
/// Returns the vector scaled to length 1; the zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
    const double length = norm(a);
    return length > 0.0 ? (1.0 / length) * a : a;
}
/// Returns the vector, rotated by 90 degrees counter-clockwise.
constexpr Vec2 left_normal(Vec2 a) {
    return {-a.y, a.x};
}

}  // namespace ncsim
