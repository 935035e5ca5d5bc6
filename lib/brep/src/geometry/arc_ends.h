// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles whose arcs end exactly in their corners. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"

#include <optional>

namespace ncsim::brep {

/// Distance below which readers take two points for a single point, with a margin of two, mm.
/// OpenCASCADE gives vertices and edges a tolerance of 1e-7.
inline constexpr double kReaderResolution = 2e-7;

/// Distance below which curves near a corner count as tangent, mm; the rest is rounding.
/// OpenCASCADE looks for crossings to 1e-10.
inline constexpr double kTangentMm = 1e-10;

/// Returns the circle through `tangent_at` and `other` that has the axis of `circle` and, in
/// `tangent_at`, the direction of `circle`. Circles that are meant to be tangent in a corner but
/// miss the corner by `d` cross about sqrt(d / difference of curvatures) away from the corner, far
/// outside any tolerance; the returned circles are tangent in the corner itself.
/// Returns: no value if the result is off `circle` by more than `kReaderResolution`.
std::optional<Circle> circle_through(const Circle& circle, Vec3 tangent_at, Vec3 other);

/// Returns the angle in `p` between the directions of two circles with the same axis, rad.
double angle_between(const Circle& a, const Circle& b, Vec3 p);

}  // namespace ncsim::brep
