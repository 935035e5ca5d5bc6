// SPDX-License-Identifier: GPL-3.0-or-later
//
// How two surfaces meet: decided by what they are, never by the angle at a point, which cannot tell
// surfaces that touch from some that cross.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface.h"

#include <optional>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Programs round their numbers, so that lines and arcs miss each other where they should touch. By
/// less than this they do, mm.
inline constexpr double kTouchMm = 3e-3;

/// Where two surfaces touch along a curve: a third one that crosses both there (the plane in which
/// the tool stood, as a rule). Nothing if they do not.
std::optional<Form> touch(const Form& a, const Form& b);

/// Of two pipes that bend into each other: the plane near `p` in which they meet.
std::optional<Form> mitre_of(const Form& a, const Form& b, Vec3 p);

/// Level circles of one radius that move along two lines meet in a circle and in an ellipse: which
/// of the two points in which these cross is nearer to `p`. There an edge may go on from the one to
/// the other.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p);

/// The same where the one of `p` and `q` lies on the circle and the other on the ellipse: the one
/// nearer to that on the circle.
std::optional<Vec3> corner_of_bend(const Form& a, const Form& b, Vec3 p, Vec3 q);

/// Of such forms: if `p` lies on the circle alone, the plane of the ellipse.
std::optional<Form> ellipse_of_bend(const Form& a, const Form& b, Vec3 p);

/// Where a level plane and a wall both touch a dome among `forms`, and none of the three tells how
/// far along the wall they do: the plane across it.
std::optional<Form> corner_of_dome(std::span<const Form* const> forms);

/// Where circles in which upright forms meet a level plane touch, one of them of an extrusion, a
/// dome or a coil, the forms cross elsewhere: planes through both centres, across the circles
/// there.
std::vector<Form> touches_in_level(std::span<const Form* const> forms);

/// Do two forms share an axis, so that they meet in circles, a straight line, or an ellipse? Then
/// the curve through `p`, which is on both; `q` is another point of it, and it passes by `near_to`.
/// Nothing: a spline has to be laid through it.
std::optional<Curve> meet(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 near_to);

/// Moves `p` to a point of all forms, the nearest as far as Newton's method finds it. Where they
/// have none in common, as near to all of them as may be. Returns the largest distance.
double solve(std::span<const Form* const> forms, Vec3& p);

}  // namespace ncsim::brep
