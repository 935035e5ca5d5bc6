// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles whose arcs end exactly in their corners. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"

#include <optional>

namespace ncsim::brep {

/// Returns the circle through `tangent_at` and `other` that has the axis of `circle` and, in
/// `tangent_at`, the direction of `circle`. Circles that are meant to be tangent in a corner but
/// miss the corner by `d` cross about sqrt(d / difference of curvatures) away from the corner, far
/// outside any tolerance; the returned circles are tangent in the corner itself.
/// Returns: no value if the result is off `circle` by more than twice `kReaderMm`.
std::optional<Circle> circle_through(const Circle& circle, Vec3 tangent_at, Vec3 other);

/// Returns the angle in `p` between the directions of two circles with the same axis, rad.
double angle_between(const Circle& a, const Circle& b, Vec3 p);

}  // namespace ncsim::brep
