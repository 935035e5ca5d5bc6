// SPDX-License-Identifier: GPL-3.0-or-later
//
// Source: Piegl, Tiller, "The NURBS Book", A2.2 and A2.3 (basis functions and their derivatives).
#include "geometry/spline_surface.h"

#include <algorithm>
#include <cstddef>

namespace ncsim::brep {

namespace {

// The basis functions that are not zero at a parameter, with derivatives; the first belongs to
// control point `first`.
struct Basis {
    std::size_t first = 0;
    std::array<double, 6> value{}, derivative{};  // The degree is at most 5.
};

// Knot `i` of the vector with multiplicities: degree + 1 at the ends, half of this inside.
double knot(const std::vector<double>& knots, std::size_t degree, std::size_t i) {
    if (i <= degree) return knots.front();
    const std::size_t inner = (degree + 1) / 2;
    return knots[std::min(1 + (i - degree - 1) / inner, knots.size() - 1)];
}

Basis basis_at(const std::vector<double>& knots, std::size_t degree, double t) {
    t = std::clamp(t, knots.front(), knots.back());
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
    const auto piece = static_cast<std::size_t>(above - knots.begin()) - 1;
    const std::size_t span = degree + piece * ((degree + 1) / 2);
    Basis basis;
    basis.first = span - degree;
    // Knots from the first function's on.
    std::array<double, 12> at{};
    for (std::size_t i = 0; i <= 2 * degree + 1; ++i)
        at[i] = knot(knots, degree, basis.first + i);
    std::array<double, 6>& n = basis.value;
    n[0] = 1.0;
    for (std::size_t j = 1; j <= degree; ++j) {
        if (j == degree) {
            // Derivatives come from the functions of the degree before.
            const auto share = [&](std::size_t k) {
                return n[k] / (at[k + 1 + degree] - at[k + 1]);
            };
            double before = 0.0;
            for (std::size_t r = 0; r <= degree; ++r) {
                const double after = r < degree ? share(r) : 0.0;
                basis.derivative[r] = static_cast<double>(degree) * (before - after);
                before = after;
            }
        }
        double saved = 0.0;
        for (std::size_t r = 0; r < j; ++r) {
            const double right = at[degree + r + 1] - t;
            const double left = t - at[degree + 1 + r - j];
            const double ratio = n[r] / (right + left);
            n[r] = saved + right * ratio;
            saved = left * ratio;
        }
        n[j] = saved;
    }
    return basis;
}

}  // namespace

PatchPoint point_of(const Patch& patch, double around, double along) {
    const auto degree = static_cast<std::size_t>(patch.degree);
    const Basis u = basis_at(patch.around, degree, around);
    const Basis v = basis_at(patch.along, degree, along);
    PatchPoint point;
    for (std::size_t i = 0; i <= degree; ++i) {
        Vec3 row, slope;
        for (std::size_t j = 0; j <= degree; ++j) {
            const Vec3& p = patch.net[u.first + i][v.first + j];
            row = row + v.value[j] * p;
            slope = slope + v.derivative[j] * p;
        }
        point.at = point.at + u.value[i] * row;
        point.by_around = point.by_around + u.derivative[i] * row;
        point.by_along = point.by_along + u.value[i] * slope;
    }
    return point;
}

}  // namespace ncsim::brep
