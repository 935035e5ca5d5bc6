// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"

namespace ncsim::toolpath {

/// The smallest box (mm) around the path of the linear axes, X + U, Y + V, Z + W: what the travels
/// of a machine are compared with. To rounding for lines, arcs and helices; of spirals no more than
/// 1e-9 mm larger; of splines the box of their control points, which contains them; of arcs in
/// tilted planes that of balls around them. Empty for dwells and tool changes.
cda::Box extent_of_path(const gcode::Motion& motion);

/// Where X, Y and Z of the machine are meanwhile, as W counts them: of a motion that tells places
/// of the tip, asked every quarter of a degree and at the ends, so that between them it may be out
/// by 2.4 um a metre of distance from the axes. Empty where the axes cannot bring the tip there.
cda::Box extent_of_joints(const gcode::Motion& motion, const Kinematics& machine);

}  // namespace ncsim::toolpath
