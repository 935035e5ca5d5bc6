// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splines as lines and arcs.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"

#include <vector>

namespace ncsim::toolpath {

/// A line or a level arc of a spline.
struct SplinePiece {
    cda::Vec3 from, to;            ///< mm, in the coordinates in which the spline is told.
    cda::Vec3 centre;              ///< Of an arc.
    double radius = 0.0;           ///< mm; of lines 0.
    double swept_degrees = 0.0;    ///< Of an arc, counter-clockwise.
    bool begins_in_corner = true;  ///< Else it goes on as the one before ends.
};

/// The spline as biarcs: pairs of arcs that go on in one direction between points of the curve in
/// which they have its direction, halved until they are within `tolerance_mm` of it. Nothing if it
/// stands still somewhere, or is not sound. O(n) of pieces, 4096 at most (K. M. Bolton, Biarc
/// curves, Computer-Aided Design 7, 1975).
std::vector<SplinePiece> arcs_of(const gcode::Spline& spline, double tolerance_mm);

}  // namespace ncsim::toolpath
