// SPDX-License-Identifier: GPL-3.0-or-later
//
// How faces go around an axis.
#pragma once

#include "ncsim/brep/part.h"

#include <vector>

namespace ncsim::brep {

/// Points along the loops of a face, in order, and where each edge ends.
std::vector<std::vector<Vec3>> points_along(const Part& part, const Face& face);

/// What loops cover of a turn about an axis, degrees.
struct Round {
    double gap_begin = 0.0, gap = 0.0;  ///< The widest that they do not.
    bool goes_round = false;            ///< One of them does, as a whole.
    double sum = 0.0;                   ///< Of all of them.
    double nearest = 1.0;  ///< Sine of the angle between a point and the axis, at least.
};

/// Angles count from `x`, which is at right angles to `axis`.
Round round_of(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis, Vec3 x);

/// The angle by which points go round an axis one after the other, degrees, signed: less than half
/// a turn from each to the next.
double turned(const std::vector<Vec3>& points, Vec3 centre, Vec3 axis);

}  // namespace ncsim::brep
