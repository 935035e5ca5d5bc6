// SPDX-License-Identifier: GPL-3.0-or-later
#include "domination.h"

#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <cmath>

namespace ncsim::cda {

namespace {

// Of the evaluation of a bound, in units of n times half units: rounding of e (below 2^53), and of
// the sum relative to its largest terms, with room to spare.
constexpr double kRoundingOfE = 16.0;
constexpr double kRelativeRounding = 1e-14;

// Does {m·x <= e_m} within the box imply p·x <= e_p?
Domination implies(const BoxPlane& m, const BoxPlane& p, const std::array<double, 3>& half) {
    const double cx = m.n[1] * p.n[2] - m.n[2] * p.n[1];
    const double cy = m.n[2] * p.n[0] - m.n[0] * p.n[2];
    const double cz = m.n[0] * p.n[1] - m.n[1] * p.n[0];
    const double along = m.n[0] * p.n[0] + m.n[1] * p.n[1] + m.n[2] * p.n[2];
    if (cx == 0 && cy == 0 && cz == 0) {
        if (along < 0) return Domination::None;
        const int order = compare_distances(*m.exact, *p.exact);
        return order < 0    ? Domination::None
               : order == 0 ? Domination::Coplanar
                            : Domination::Strict;
    }
    // max p·x <= min over λ >= 0 of λ e_m + Σ |p_i − λ m_i| half_i: convex, piecewise linear; the
    // least value is at a kink.
    for (std::size_t i = 0; i < 3; ++i) {
        const double lambda = p.n[i] / m.n[i];
        if (!(lambda > 0) || !(lambda < 1e9)) continue;
        double bound = lambda * m.e;
        double size = std::abs(bound);
        for (std::size_t k = 0; k < 3; ++k) {
            bound += std::abs(p.n[k] - lambda * m.n[k]) * half[k];
            size += (std::abs(p.n[k]) + lambda * std::abs(m.n[k])) * half[k];
        }
        const double margin = kRoundingOfE * (1.0 + lambda) + kRelativeRounding * size;
        if (bound + margin < p.e) return Domination::Strict;
    }
    return Domination::None;
}

}  // namespace

Domination dominated(std::span<const BoxPlane> cell, std::span<const BoxPlane> by,
                     const std::array<double, 3>& half) {
    Domination result = Domination::Strict;
    for (const BoxPlane& p : by) {
        Domination best = Domination::None;
        for (const BoxPlane& m : cell) {
            const Domination found = implies(m, p, half);
            if (found > best) best = found;
            if (best == Domination::Strict) break;
        }
        if (best == Domination::None) return best;
        result = std::min(result, best);
    }
    return result;
}

std::uint64_t sample_mask(std::span<const BoxPlane> cell, const std::array<double, 3>& half) {
    // Three fifths apart about the middle: corners of the box tell little.
    constexpr std::array<double, 4> kAt{-0.9, -0.3, 0.3, 0.9};
    std::uint64_t inside = ~std::uint64_t{0};
    for (const BoxPlane& p : cell) {
        const double x = p.n[0] * half[0];
        const double y = p.n[1] * half[1];
        const double z = p.n[2] * half[2];
        std::uint64_t here = 0;
        for (std::size_t k = 0; k < 16; ++k) {
            const double rest = p.e - y * kAt[k & 3] - z * kAt[k >> 2];
            const unsigned bits = static_cast<unsigned>(x * kAt[0] <= rest) |
                                  static_cast<unsigned>(x * kAt[1] <= rest) << 1 |
                                  static_cast<unsigned>(x * kAt[2] <= rest) << 2 |
                                  static_cast<unsigned>(x * kAt[3] <= rest) << 3;
            here |= std::uint64_t{bits} << (4 * k);
        }
        inside &= here;
    }
    return inside;
}

bool same_direction(const Plane& a, const Plane& b) {
    return std::int64_t{a.nx} * b.nx + std::int64_t{a.ny} * b.ny + std::int64_t{a.nz} * b.nz > 0;
}

int compare_distances(const Plane& a, const Plane& b) {
    // d/|n| in a component that is not zero: parallel normals are in proportion.
    const auto component = [axis = a.nx != 0   ? 0
                                   : a.ny != 0 ? 1
                                               : 2](const Plane& p) {
        return static_cast<Int128>(std::abs(axis == 0 ? p.nx : axis == 1 ? p.ny : p.nz));
    };
    const Int128 difference = b.d * component(a) - a.d * component(b);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

}  // namespace ncsim::cda
