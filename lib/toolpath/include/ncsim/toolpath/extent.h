// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes around motions, for comparison with the travels of a machine.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"

namespace ncsim::toolpath {

/// Returns the smallest box (mm, workpiece frame W) around the path of Poses::place(): the linear
/// axes X + U, Y + V, Z + W, or the tip under tip control. The travels of a machine are compared
/// with this box. Empty for dwells and tool changes.
///
/// Guarantees: the box contains the path and is
/// - exact to rounding for lines, arcs and helices,
/// - at most 1e-9 mm too large for spirals,
/// - the box of the control points for splines, which contains the curve,
/// - the box of two balls about the centre, at start and end, for arcs in tilted planes,
/// - enlarged by the reach of U, V and W under tip control, if these axes move the tip on an arc,
///   on a spline or during a rotary move.
Box extent_of_path(const gcode::Motion& motion, const Poses& poses);

/// Returns the box of the machine's X, Y and Z (mm, relative to the program zero) during `motion`,
/// for a motion that does not give these positions, such as a move under tip control. The axes are
/// computed every 0.25 degrees and at the ends, so the box may be too small by 2.4 µm per metre of
/// distance from the rotary axes. Empty if the axes cannot bring the tip to the path.
Box extent_of_joints(const gcode::Motion& motion, const Kinematics& machine);

}  // namespace ncsim::toolpath
