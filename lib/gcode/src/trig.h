// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trigonometry in degrees that gives the same bits everywhere (the C library's does not) and
// is exact where machinists expect it: sin 30 = 0.5, cos 90 = 0.
#pragma once

namespace ncsim::gcode {

struct SinCos {
    double sin, cos;
};

/// Within 2 ulp; exact at multiples of 90 and, for sin 30 and cos 60, there too.
SinCos sin_cos_degrees(double degrees);

/// The angle of (x, y) in degrees, -180 … 180; 0 for the origin. Within 2 ulp.
double atan2_degrees(double y, double x);

}  // namespace ncsim::gcode
