// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles that faces cover around an axis.
#pragma once

#include "ncsim/brep/part.h"

#include <vector>

namespace ncsim::brep {

/// Returns points along the loops of a face, in order, including all vertices.
std::vector<std::vector<Vec3>> points_along(const Part& part, const Face& face);

/// Angles about an axis that loops cover, degrees.
struct AngularExtent {
    double gap_begin = 0.0, gap = 0.0;  ///< Widest range that no loop covers.
    bool is_full_turn = false;          ///< True if a loop goes all round.
    double sum = 0.0;                   ///< Signed sum over all loops.
    double nearest = 1.0;               ///< Least sine of the angle between a point and the axis.
};

/// Returns the angles that `loops` cover about `axis`, from `x`, which is perpendicular to `axis`.
AngularExtent angular_extent(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis,
                             Vec3 x);

/// Returns the signed angle by which consecutive points go round an axis, degrees.
/// Requires: less than half a turn between consecutive points.
double winding_angle(const std::vector<Vec3>& points, Vec3 centre, Vec3 axis);

}  // namespace ncsim::brep
