// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sine, cosine and arctangent with the same bits on every machine. Standard libraries differ in the
// last bit, and no output of ncsim may depend on that bit. The functions use only + - × ÷ √ and the
// exact remainder. tests/base checks that sources of ncsim do not call std::sin and similar
// functions, with a list of exceptions.
#pragma once

#include <numbers>

namespace ncsim {

/// Factor from degrees to radians.
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// A whole turn, half of a turn and a right angle, degrees.
inline constexpr double kTurnDegrees = 360.0, kHalfTurnDegrees = 180.0, kQuarterTurnDegrees = 90.0;

/// Sine and cosine of the same angle.
struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Returns the sine and the cosine of an angle in degrees.
/// Guarantees: the error is at most 2^-52. Exact for multiples of 90 degrees, and sin 30 = cos 60 =
///     0.5, sin 45 = cos 45. The result for an infinity or a NaN is that for 0.
SinCos sin_cos(double degrees);

/// Returns the tangent of an angle in degrees; exactly 1 for 45 degrees.
/// Requires: cos(degrees) != 0.
double tangent(double degrees);

/// Rotates (x, y) about the origin, counter-clockwise.
void rotate(double& x, double& y, double degrees);

/// Returns the angle from the x axis to (x, y) in degrees, in (-180, 180]; 0 for the zero vector.
/// Guarantees: exact for multiples of 45 degrees; otherwise the error is at most 4e-14 degrees.
double angle_of(double x, double y);

/// Returns √(x² + y²). std::hypot is not used because its last bit depends on the library.
/// Guarantees: the error is at most two units in the last place, for all finite `x` and `y`.
double hypotenuse(double x, double y);

}  // namespace ncsim
