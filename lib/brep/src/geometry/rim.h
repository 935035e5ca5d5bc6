// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rim of a flat end on a path: a fillet of radius 0. The circle itself sweeps the surface, so
// places around the rim are angles about the tool's axis.
#pragma once

#include "ncsim/brep/profile_sweep.h"

#include <vector>

namespace ncsim::brep {

/// Returns closest_point_at() for a rim. The sign of `deviation` is that of the side of the surface
/// that the circle sweeps at this time; `rate`, `drift` and `bend` are derivatives of deviation²
/// / 2.
ClosestPoint closest_point_on_rim(const Fillet& rim, const ToolFrame& at, Vec3 p);
/// Returns times near which the rim may be nearest to `p`: the time when `p` leaves the circle of a
/// descending tool or enters the circle of a rising tool, or the time of the least distance.
std::vector<double> rim_start_times(const Sweep& sweep, Vec3 p);
/// Returns gradient_of_rise() for a rim, for a closest point at the nearest time.
Vec3 gradient_of_rise_of_rim(const Fillet& rim, const ClosestPoint& closest);

/// Returns degrees about the tool's axis: 180 is ahead if the tool rises, behind if it descends; 90
/// is on the side of path_frame().
double place_on_rim(const Sweep& sweep, const ToolFrame& tool, Vec3 p);
Vec3 point_on_rim(const Sweep& sweep, const ToolFrame& tool, double place);

}  // namespace ncsim::brep
