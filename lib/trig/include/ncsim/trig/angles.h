// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sine, cosine and arctangent that give the same bits everywhere: no two standard
// libraries agree on their last bit, and what reaches an output must not depend on them. Only
// + - × ÷ √ and the exact remainder are used. Nobody else calls the library's: tests/trig.
#pragma once

namespace ncsim::trig {

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Within 2^-52 of the truth for |degrees| below 1e6; exact for multiples of 90 degrees.
SinCos sin_cos(double degrees);

/// Requires cos != 0.
double tangent(double degrees);

/// The angle of (x, y) against the x axis in degrees, in (-180, 180]; exact for multiples of
/// 45 degrees, else within 4e-14. 0 for the zero vector.
double angle_of(double x, double y);

/// √(x² + y²): std::hypot differs in its last bit, too. Of coordinates: within 1e-150 … 1e150, or
/// 0.
double length_of(double x, double y);

}  // namespace ncsim::trig
