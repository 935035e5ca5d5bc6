// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions for tests of tool paths.
#pragma once

#include "ncsim/gcode/motion.h"

namespace ncsim::toolpath {

/// Returns a position from millimetres and degrees.
inline gcode::Position at(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
    using gcode::Angle;
    using gcode::Length;
    gcode::Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = Angle::from_degrees(a), p.b = Angle::from_degrees(b), p.c = Angle::from_degrees(c);
    return p;
}

}  // namespace ncsim::toolpath
