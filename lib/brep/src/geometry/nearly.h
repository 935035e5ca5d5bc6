// SPDX-License-Identifier: GPL-3.0-or-later
//
// When directions and lengths count as equal, of surfaces that meet.
#pragma once

#include "ncsim/cda/vec.h"

#include <cmath>

namespace ncsim::brep {

using cda::Vec3;

/// Programs round their numbers, so that lines and arcs miss each other where they should touch. By
/// less than this they do, mm.
inline constexpr double kTouchMm = 3e-3;
inline constexpr double kNearlyParallel = 1e-5;  ///< rad
/// Axes nearer than this are one, or nothing can be said of them, mm.
inline constexpr double kApart = 0.01;

inline bool is_parallel(Vec3 a, Vec3 b) {
    return cda::norm(cda::cross(a, b)) <= kNearlyParallel;
}
inline bool is_across(Vec3 a, Vec3 b) {
    return std::abs(cda::dot(a, b)) <= kNearlyParallel;
}
/// Lengths, but for what programs round.
inline bool near(double a, double b) {
    return std::abs(a - b) <= kTouchMm;
}
/// From the axis to the point, at right angles.
inline Vec3 away(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    return v - cda::dot(v, axis) * axis;
}

}  // namespace ncsim::brep
