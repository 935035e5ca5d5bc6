// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors of the half-plane in which profiles are drawn: distance from the axis and height, in
// lattice units; and how such numbers become integers.
#pragma once

#include <cmath>
#include <cstdint>

namespace ncsim::toolpath {

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
inline HalfPlaneVec left_of(HalfPlaneVec a) {
    return {-a.h, a.r};
}
inline HalfPlaneVec unit(HalfPlaneVec a) {
    const double n = norm(a);
    return n > 0 ? (1 / n) * a : a;
}

/// Numbers that are integers but for the rounding of a division or a sine stay what they are.
inline constexpr double kIntegerGuard = 1e-7;
inline std::int64_t round_up(double v) {
    return static_cast<std::int64_t>(std::ceil(v - kIntegerGuard));
}
inline std::int64_t round_down(double v) {
    return static_cast<std::int64_t>(std::floor(v + kIntegerGuard));
}

}  // namespace ncsim::toolpath
