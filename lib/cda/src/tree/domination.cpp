// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests whether planes or cells cover others within a box.
#include "tree/domination.h"

#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <cmath>

namespace ncsim::cda {

namespace {

// Rounding errors of a bound, in units of n times half units: absolute error of e (below 2^53), and
// relative error of the sum, with a safety margin.
constexpr double kRoundingOfE = 16.0;
constexpr double kRelativeRounding = 1e-14;

}  // namespace

Domination implies(const BoxPlane& m, const BoxPlane& p) {
    // Necessary condition: the corner of the box that is farthest above p is above m.
    double height = -m.e;
    for (std::size_t i = 0; i < 3; ++i)
        height += std::copysign(1.0, p.n[i]) * m.n[i];
    if (height < 0) return Domination::None;
    // max p·x <= min over λ >= 0 of λ e_m + Σ |p_i − λ m_i|. The bound is convex and piecewise
    // linear in λ, so the minimum is at a kink.
    for (std::size_t i = 0; i < 3; ++i) {
        const double lambda = p.n[i] * m.inverse[i];
        if (lambda <= 0) continue;
        double bound = lambda * m.e;
        for (std::size_t k = 0; k < 3; ++k)
            bound += std::abs(p.n[k] - lambda * m.n[k]);
        const double size = p.size + lambda * (m.size + std::abs(m.e));
        const double margin = kRoundingOfE * (1.0 + lambda) + kRelativeRounding * size;
        if (bound + margin < p.e) return Domination::Strict;
    }
    // Equal or nearly equal planes are decided in integers.
    if (!m.exact->is_parallel_to(*p.exact) || !same_direction(*m.exact, *p.exact)) {
        return Domination::None;
    }
    const int order = compare_distances(*m.exact, *p.exact);
    return order < 0 ? Domination::None : order == 0 ? Domination::Coplanar : Domination::Strict;
}

Domination dominated(std::span<const BoxPlane> cell, std::span<const BoxPlane> by) {
    Domination result = Domination::Strict;
    for (const BoxPlane& p : by) {
        Domination best = Domination::None;
        for (const BoxPlane& m : cell) {
            const Domination found = implies(m, p);
            if (found > best) best = found;
            if (best == Domination::Strict) break;
        }
        if (best == Domination::None) return best;
        result = std::min(result, best);
    }
    return result;
}

}  // namespace ncsim::cda
