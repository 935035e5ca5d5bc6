// SPDX-License-Identifier: GPL-3.0-or-later
#include "trig.h"

#include <cmath>
#include <numbers>

namespace ncsim::gcode {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Taylor series of sin and cos about 0 for |x| <= pi/4: the next term is below 2^-54.
double sin_small(double x) {
    const double y = x * x;
    double sum = -1.0 / 1307674368000.0;
    sum = sum * y + 1.0 / 6227020800.0;
    sum = sum * y - 1.0 / 39916800.0;
    sum = sum * y + 1.0 / 362880.0;
    sum = sum * y - 1.0 / 5040.0;
    sum = sum * y + 1.0 / 120.0;
    sum = sum * y - 1.0 / 6.0;
    return x + x * (sum * y);
}
double cos_small(double x) {
    const double y = x * x;
    double sum = 1.0 / 20922789888000.0;
    sum = sum * y - 1.0 / 87178291200.0;
    sum = sum * y + 1.0 / 479001600.0;
    sum = sum * y - 1.0 / 3628800.0;
    sum = sum * y + 1.0 / 40320.0;
    sum = sum * y - 1.0 / 720.0;
    sum = sum * y + 1.0 / 24.0;
    sum = sum * y - 0.5;
    return 1.0 + sum * y;
}

/// atan for 0 <= x <= 1 in radians: three halvings of the angle, then the series.
double atan_unit(double x) {
    double scale = 1.0;
    for (int i = 0; i < 3; ++i) {
        x = x / (1.0 + std::sqrt(1.0 + x * x));
        scale *= 2.0;
    }
    const double y = x * x;  // x < 0.1: 12 terms are below 2^-60
    double sum = 0.0;
    for (int n = 12; n >= 1; --n) {
        sum = y * ((n % 2 == 0 ? 1.0 : -1.0) / (2.0 * n + 1.0) + sum);
    }
    return scale * (x + x * sum);
}

}  // namespace

SinCos sin_cos_degrees(double degrees) {
    if (!std::isfinite(degrees)) return {0.0, 1.0};
    const double turn = std::remainder(degrees, 360.0);  // exact
    const int quarter = static_cast<int>(std::nearbyint(turn / 90.0));
    const double rest = turn - 90.0 * quarter;  // exact, |rest| <= 45
    double s = sin_small(rest * kRadians);
    double c = cos_small(rest * kRadians);
    if (std::abs(rest) == 30.0) s = std::copysign(0.5, rest);
    switch (quarter & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

double atan2_degrees(double y, double x) {
    const double ax = std::abs(x);
    const double ay = std::abs(y);
    if (ax == 0.0 && ay == 0.0) return 0.0;
    double angle = 0.0;
    if (ay == ax) {
        angle = 45.0;
    } else if (ay < ax) {
        angle = atan_unit(ay / ax) / kRadians;
    } else {
        angle = 90.0 - atan_unit(ax / ay) / kRadians;
    }
    if (x < 0.0) angle = 180.0 - angle;
    return std::copysign(angle, y);
}

}  // namespace ncsim::gcode
