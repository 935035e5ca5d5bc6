// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles whose arcs end exactly in their corners. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"

#include <optional>

namespace ncsim::brep {

/// Length below which readers take two points for one, with a margin of two, mm. OpenCASCADE gives
/// vertices and edges a tolerance of 1e-7.
inline constexpr double kReaders = 2e-7;

/// Curves that part by less than this near a corner are tangent there but for the rounding of
/// numbers, mm. OpenCASCADE looks for crossings to 1e-10.
inline constexpr double kTangentMm = 1e-10;

/// Returns the circle through `tangent_at` and `other` that has the axis of `circle` and, in
/// `tangent_at`, its direction. Circles that are tangent in a corner but miss it by `d` cross about
/// sqrt(d / difference of curvatures) away from it, far outside of any tolerance; the ones returned
/// touch in the corner itself. Nothing if the result is off `circle` by more than `kReaders`.
std::optional<Circle> circle_through(const Circle& circle, Vec3 tangent_at, Vec3 other);

/// Angle in `p` between the directions of two circles of one axis, rad.
double angle_between(const Circle& a, const Circle& b, Vec3 p);

}  // namespace ncsim::brep
