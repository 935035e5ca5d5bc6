// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rim of a flat end on its way: a fillet whose radius is 0. What it leaves is where the circle
// itself passes, so places around it are angles about the tool's axis.
#pragma once

#include "ncsim/brep/sweep.h"

#include <vector>

namespace ncsim::brep {

/// As aspect_at(). `off` has the sign of the side of what the circle passes at that time; instead
/// of its derivatives `rate`, `drift` and `bend` are those of half its square.
Aspect aspect_of_rim(const Fillet& rim, const Passage& at, Vec3 p);
/// Times near which it may be nearest: when a point comes out of the circle of a tool that goes
/// down, and into it where it rises, or is as near to it as it gets.
std::vector<double> starts_on_rim(const Sweep& sweep, Vec3 p);
/// Of an aspect at the time when it is nearest.
Vec3 gradient_of_rise_of_rim(const Fillet& rim, const Aspect& aspect);

/// Degrees about the axis: 180 is ahead where the tool rises, behind where it goes down, 90 is on
/// the side of around().
double place_on_rim(const Sweep& sweep, const Passage& passage, Vec3 p);
Vec3 point_on_rim(const Sweep& sweep, const Passage& passage, double place);

}  // namespace ncsim::brep
