// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"

namespace ncsim::toolpath {

/// The smallest box (mm) around the way of Poses::place(), of the linear axes, X + U, Y + V, Z + W,
/// or the tip: what the travels of a machine are compared with. To rounding for lines, arcs and
/// helices; of spirals no more than 1e-9 mm larger; of splines the box of their control points,
/// which contains them; of arcs in tilted planes that of balls around them; larger by as much as U,
/// V and W tell where they move the tip while it turns, or on an arc. Empty for dwells and tool
/// changes.
cda::Box extent_of_path(const gcode::Motion& motion, const Poses& poses);

/// Where X, Y and Z of the machine are meanwhile, as W counts them: of a motion that does not tell
/// these itself, asked every quarter of a degree and at the ends, so that between them it may be
/// out by 2.4 um a metre of distance from the axes. Empty where the axes cannot bring the tip
/// there.
cda::Box extent_of_joints(const gcode::Motion& motion, const Kinematics& machine);

}  // namespace ncsim::toolpath
