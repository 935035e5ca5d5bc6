// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tolerances for directions and lengths of surfaces that meet.
#pragma once

#include "ncsim/base/vec3.h"

#include <cmath>

namespace ncsim::brep {

/// Largest gap at which surfaces count as tangent, mm. Programs round numbers, so lines and arcs
/// that are meant to be tangent miss each other.
inline constexpr double kTangencyGapMm = 3e-3;
inline constexpr double kParallelAngle = 1e-5;  ///< rad
/// Least distance of distinct axes, mm. Closer axes count as equal, or the case stays undecided.
inline constexpr double kLeastAxisDistance = 0.01;

inline bool is_parallel(Vec3 a, Vec3 b) {
    return norm(cross(a, b)) <= kParallelAngle;
}
inline bool is_perpendicular(Vec3 a, Vec3 b) {
    return std::abs(dot(a, b)) <= kParallelAngle;
}
/// True if two lengths are equal except for rounding in programs.
inline bool is_near(double a, double b) {
    return std::abs(a - b) <= kTangencyGapMm;
}
/// Returns the vector from the axis to `p`, perpendicular to the axis.
inline Vec3 radial_vector(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    return v - dot(v, axis) * axis;
}

}  // namespace ncsim::brep
