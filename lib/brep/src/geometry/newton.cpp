// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method with the shortest step, for any number of forms.
#include "geometry/newton.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi rotations.
struct Eigen {
    std::array<double, 3> values;
    std::array<Vec3, 3> vectors;
};

Eigen eigen(std::array<std::array<double, 3>, 3> m) {
    std::array<std::array<double, 3>, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const double trace = m[0][0] + m[1][1] + m[2][2];
    for (int sweep = 0; sweep < 12; ++sweep) {
        const double off_diagonal = std::abs(m[0][1]) + std::abs(m[0][2]) + std::abs(m[1][2]);
        if (off_diagonal <= 1e-18 * trace) break;
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (m[p][q] == 0.0) continue;
            const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            const double t =
                (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
            const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = m[k][p], b = m[k][q];
                m[k][p] = c * a - s * b;
                m[k][q] = s * a + c * b;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = m[p][k], b = m[q][k];
                m[p][k] = c * a - s * b;
                m[q][k] = s * a + c * b;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double a = v[k][p], b = v[k][q];
                v[k][p] = c * a - s * b;
                v[k][q] = s * a + c * b;
            }
        }
    }
    Eigen result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result.values[i] = m[i][i];
        result.vectors[i] = {v[0][i], v[1][i], v[2][i]};
    }
    return result;
}

// Returns the shortest step that best solves m step = right, for a matrix that may be singular.
Vec3 shortest_step(const std::array<std::array<double, 3>, 3>& m, Vec3 right) {
    // A well-conditioned matrix is inverted by cofactors.
    const Vec3 x{m[0][0], m[0][1], m[0][2]}, y{m[1][0], m[1][1], m[1][2]};
    const Vec3 z{m[2][0], m[2][1], m[2][2]};
    const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const double determinant = dot(x, yz), mean = (x.x + y.y + z.z) / 3.0;
    if (determinant > 1e-2 * mean * mean * mean)
        return (1.0 / determinant) * (right.x * yz + right.y * zx + right.z * xy);
    const Eigen e = eigen(m);
    const double largest = std::max({e.values[0], e.values[1], e.values[2]});
    Vec3 step;
    for (std::size_t i = 0; i < 3; ++i) {
        if (e.values[i] > kRounding * largest)
            step = step + (dot(right, e.vectors[i]) / e.values[i]) * e.vectors[i];
    }
    return step;
}

}  // namespace

double solve(std::span<const Form* const> forms, Vec3& p) {
    std::vector<ProjectionSeed> seeds(forms.size());
    return solve(forms, p, seeds);
}

double solve(std::span<const Form* const> forms, Vec3& p, std::span<ProjectionSeed> seeds) {
    // Steps this short are rounding errors as soon as they do not become shorter.
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step) {
        std::array<std::array<double, 3>, 3> m{};
        Vec3 right;
        for (std::size_t k = 0; k < forms.size(); ++k) {
            const auto [d, g] = evaluate(*forms[k], p, seeds[k]);
            right = right - d * g;
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j)
                    m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += g[i] * g[j];
            }
        }
        const Vec3 move = shortest_step(m, right);
        const double length = norm(move);
        // Steps of at most 1 mm stay near the corner that is wanted.
        p = p + (length > 1.0 ? 1.0 / length : 1.0) * move;
        if (length == 0.0 || (length < 0.1 * kRounding && length > 0.5 * before)) break;
        before = length;
    }
    double miss = 0.0;
    for (std::size_t k = 0; k < forms.size(); ++k)
        miss = std::max(miss, std::abs(distance(*forms[k], p, seeds[k])));
    return miss;
}

}  // namespace ncsim::brep
