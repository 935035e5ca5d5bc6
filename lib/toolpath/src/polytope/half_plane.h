// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors of the half-plane of profiles: distance from the axis and height, in lattice units; and
// rounding of such numbers to integers.
#pragma once

#include <cmath>
#include <cstdint>

namespace ncsim::toolpath {

/// Distance from the axis and height, in lattice units.
struct HalfPlaneVec {
    double r = 0.0, h = 0.0;
    friend HalfPlaneVec operator+(HalfPlaneVec a, HalfPlaneVec b) { return {a.r + b.r, a.h + b.h}; }
    friend HalfPlaneVec operator-(HalfPlaneVec a, HalfPlaneVec b) { return {a.r - b.r, a.h - b.h}; }
    friend HalfPlaneVec operator*(double s, HalfPlaneVec a) { return {s * a.r, s * a.h}; }
};

inline double dot(HalfPlaneVec a, HalfPlaneVec b) {
    return a.r * b.r + a.h * b.h;
}
inline double cross(HalfPlaneVec a, HalfPlaneVec b) {
    return a.r * b.h - a.h * b.r;
}
inline double norm(HalfPlaneVec a) {
    return std::sqrt(dot(a, a));
}
inline HalfPlaneVec left_normal(HalfPlaneVec a) {
    return {-a.h, a.r};
}
inline HalfPlaneVec unit(HalfPlaneVec a) {
    const double n = norm(a);
    return n > 0 ? (1 / n) * a : a;
}

/// Tolerance of the rounding: numbers that are integers except for the rounding of a division or a
/// sine keep their value.
inline constexpr double kIntegerGuard = 1e-7;
inline std::int64_t round_up(double v) {
    return static_cast<std::int64_t>(std::ceil(v - kIntegerGuard));
}
inline std::int64_t round_down(double v) {
    return static_cast<std::int64_t>(std::floor(v + kIntegerGuard));
}

}  // namespace ncsim::toolpath
