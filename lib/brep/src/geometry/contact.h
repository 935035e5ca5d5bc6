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

/// Where two surfaces touch along a curve: a third one that crosses both there (the plane in which
/// the tool stood, as a rule). Nothing if they do not.
std::optional<Form> touch(const Form& a, const Form& b);

/// Where a level plane and a wall both touch a dome among `forms`, and none of the three tells how
/// far along the wall they do: the plane across it.
std::optional<Form> corner_of_dome(std::span<const Form* const> forms);

/// Where circles in which upright forms meet a level plane touch, one of them of an extrusion, a
/// dome or a coil, or such a circle and an upright plane, the forms cross elsewhere: planes through
/// both centres, or across the wall, across the circles there.
std::vector<Form> touches_in_level(std::span<const Form* const> forms);

/// Do two forms share an axis, so that they meet in circles, a straight line, or an ellipse? Then
/// the curve through `p`, which is on both; `q` is another point of it, and it passes by `near_to`.
/// Nothing: a spline has to be laid through it.
std::optional<Curve> meet(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 near_to);

}  // namespace ncsim::brep
