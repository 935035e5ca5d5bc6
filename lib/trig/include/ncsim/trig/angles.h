// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sine, cosine and arctangent that give the same bits everywhere: no two standard
// libraries agree on their last bit, and what reaches an output must not depend on them. Only
// + - × ÷ √ and the exact remainder are used. Nobody else calls the library's: tests/trig.
#pragma once

#include <numbers>

namespace ncsim::trig {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Within 2^-52 of the truth; exact where machinists expect it: for multiples of 90 degrees, and
/// sin 30 = cos 60 = 0.5, sin 45 = cos 45. Of what is no finite number: that of 0.
SinCos sin_cos(double degrees);

/// 1 for 45 degrees. Requires cos != 0.
double tangent(double degrees);

/// Turns (x, y) about the zero, counterclockwise.
void rotate(double& x, double& y, double degrees);

/// The angle of (x, y) against the x axis in degrees, in (-180, 180]; exact for multiples of
/// 45 degrees, else within 4e-14. 0 for the zero vector.
double angle_of(double x, double y);

/// √(x² + y²), within two units of the last bit of whatever is finite: std::hypot differs there,
/// too.
double length_of(double x, double y);

}  // namespace ncsim::trig
