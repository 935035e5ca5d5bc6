// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors of the oracle, independent of ncsim, because the judge must not share code with the
// program. Millimetres; the name of a variable states the frame.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace ncsim::nightly {

using Vec = std::array<double, 3>;

inline Vec operator+(const Vec& a, const Vec& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(const Vec& a, const Vec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(double s, const Vec& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec& a) {
    return std::sqrt(dot(a, a));
}

}  // namespace ncsim::nightly
