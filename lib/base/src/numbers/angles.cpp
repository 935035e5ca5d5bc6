// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trigonometric functions as Taylor series with exact argument reduction.
#include "ncsim/base/angles.h"

#include <array>
#include <cmath>
#include <numbers>

namespace ncsim {

namespace {

// Returns ±1 / n!, the coefficient of x^n in the series of sine (n odd) or cosine (n even).
constexpr double taylor(int n) {
    double product = 1.0;
    for (int i = 2; i <= n; ++i)
        product *= i;
    return (n / 2 % 2 == 0 ? 1.0 : -1.0) / product;
}

// Sums the Taylor series of the sine for |x| <= pi/4; the first omitted term is below 2^-54.
double sine_near_zero(double x) {
    constexpr std::array kTerms{taylor(17), taylor(15), taylor(13), taylor(11),
                                taylor(9),  taylor(7),  taylor(5),  taylor(3)};
    const double q = x * x;
    double sum = 0.0;
    for (const double term : kTerms)
        sum = term + q * sum;
    return x + x * (q * sum);
}

double cosine_near_zero(double x) {
    constexpr std::array kTerms{taylor(18), taylor(16), taylor(14), taylor(12), taylor(10),
                                taylor(8),  taylor(6),  taylor(4),  taylor(2)};
    const double q = x * x;
    double sum = 0.0;
    for (const double term : kTerms)
        sum = term + q * sum;
    return 1.0 + q * sum;
}

// Returns the arctangent of `t` in degrees. The angle is halved twice, which leaves t below 0.2,
// where the series is short.
// Requires: 0 <= t <= 1.
double arctangent(double t) {
    if (t == 0.0) return 0.0;
    if (t == 1.0) return 45.0;
    for (int i = 0; i < 2; ++i)
        t = t / (1.0 + std::sqrt(1.0 + t * t));
    const double q = t * t;
    double sum = 0.0;
    for (int n = 25; n >= 1; n -= 2)
        sum = 1.0 / n - q * sum;
    return 4.0 * (t * sum) / kRadiansPerDegree;
}

// Returns `x` minus the nearest multiple of `step`, as IEEE 754 defines the remainder. The result
// is exact because the remainder is a multiple of the last bit of `x`. std::remainder is slower:
// the standard library computes the remainder bit by bit.
// Requires: `step` is a whole number.
double remainder_of(double x, double step) {
    if (!(std::abs(x) < 0x1p40)) return std::remainder(x, step);
    // Adding and subtracting this number rounds to a whole number.
    constexpr double kToWhole = 0x1.8p52;
    const double rest = x - (x / step + kToWhole - kToWhole) * step;
    // The rounded quotient x / step can differ from the nearest whole number by 1.
    if (rest > step / 2) return rest - step;
    if (rest < -step / 2) return rest + step;
    return rest == 0.0 ? std::copysign(0.0, x) : rest;
}

}  // namespace

SinCos sin_cos(double degrees) {
    if (!std::isfinite(degrees)) return {};
    const double turned = remainder_of(degrees, 360.0);
    const double rest = remainder_of(turned, 90.0);
    const double quarter_turns = std::nearbyint(turned / 90.0);
    double s = sine_near_zero(rest * kRadiansPerDegree);
    double c = cosine_near_zero(rest * kRadiansPerDegree);
    // The series are wrong in the last bit at 30 and 45 degrees.
    if (std::abs(rest) == 30.0) s = std::copysign(0.5, rest);
    if (std::abs(rest) == 45.0) {
        c = std::sqrt(0.5);
        s = std::copysign(c, rest);
    }
    switch (static_cast<int>(quarter_turns)) {
        case 1: return {c, -s};
        case -1: return {-c, s};
        case 2:
        case -2: return {-s, -c};
        default: return {s, c};
    }
}

void rotate(double& x, double& y, double degrees) {
    if (degrees == 0.0) return;
    const SinCos r = sin_cos(degrees);
    const double turned = x * r.cos - y * r.sin;
    y = x * r.sin + y * r.cos;
    x = turned;
}

double tangent(double degrees) {
    const SinCos v = sin_cos(degrees);
    return v.sin / v.cos;
}

double angle_of(double x, double y) {
    const double ax = std::abs(x);
    const double ay = std::abs(y);
    if (ax == 0.0 && ay == 0.0) return 0.0;
    double angle = ay <= ax ? arctangent(ay / ax) : 90.0 - arctangent(ax / ay);
    if (x < 0.0) angle = 180.0 - angle;
    return y < 0.0 ? -angle : angle;
}

double hypotenuse(double x, double y) {
    const double square = x * x + y * y;
    if (square > 1e-200 && std::isfinite(square)) return std::sqrt(square);
    // x² + y² overflows or underflows. Scaling by a power of two is exact.
    const double sum = std::abs(x) + std::abs(y);
    if (sum == 0.0 || !std::isfinite(sum)) return sum;
    const int scale = std::ilogb(sum);
    const double u = std::ldexp(x, -scale);
    const double v = std::ldexp(y, -scale);
    return std::ldexp(std::sqrt(u * u + v * v), scale);
}

}  // namespace ncsim
