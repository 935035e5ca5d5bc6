// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"

namespace ncsim::toolpath {

/// The smallest box (mm) around the path of the linear axes, X + U, Y + V, Z + W: what the travels
/// of a machine are compared with. To rounding for lines, arcs and helices; of spirals no more than
/// 1e-9 mm larger; of splines the box of their control points, which contains them. Empty for
/// dwells and tool changes.
cda::Box extent_of_path(const gcode::Motion& motion);

}  // namespace ncsim::toolpath
