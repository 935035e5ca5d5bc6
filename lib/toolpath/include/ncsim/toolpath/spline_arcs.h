// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of splines by lines and arcs.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"

#include <vector>

namespace ncsim::toolpath {

/// A line or an arc parallel to XY, as a piece of a spline.
struct SplinePiece {
    Vec3 from, to;               ///< mm, in the frame of the spline.
    Vec3 centre;                 ///< Centre of an arc, mm.
    double radius = 0.0;         ///< mm; 0 for a line.
    double swept_degrees = 0.0;  ///< Angle of an arc, counter-clockwise positive.
    /// False if the piece continues the preceding piece tangentially.
    bool begins_in_corner = true;
};

/// Returns the spline as biarcs: pairs of arcs with a common tangent, between points of the curve
/// at which the arcs have the curve's direction. Intervals are halved until the arcs are within
/// `tolerance_mm` of the curve. Empty if the curve stands still somewhere, is not sound, or needs
/// too many pieces.
///
/// Cost: O(n) in the number of pieces, about 4096 at most.
/// Source: K. M. Bolton, Biarc curves, Computer-Aided Design 7, 1975.
std::vector<SplinePiece> arcs_of(const gcode::Spline& spline, double tolerance_mm);

}  // namespace ncsim::toolpath
