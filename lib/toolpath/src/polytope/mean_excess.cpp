// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mean distance between a polytope and the round tool.
#include "polytope/mean_excess.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/vec2.h"

#include "polytope/profile_fillet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace ncsim::toolpath {

double mean_excess(const ToolPiece& piece, const std::vector<RingPolygon>& family,
                   const std::vector<Ring>& rings, double unit_mm) {
    constexpr std::size_t kAround = 16;  // samples of an eighth; the rest is symmetric
    constexpr int kAlong = 64;           // samples of each arc
    std::vector<std::array<double, kAround>> reaches;  // reaches of the polygons by direction
    for (const RingPolygon& polygon : family) {
        auto& reach = reaches.emplace_back();
        for (std::size_t i = 0; i < kAround; ++i) {
            const SinCos a = sin_cos((static_cast<double>(i) + 0.5) * 45.0 / kAround);
            for (const auto& [x, y] : polygon.corners) {
                reach[i] = std::max(
                    reach[i], a.cos * static_cast<double>(x) + a.sin * static_cast<double>(y));
            }
        }
    }
    double sum = 0.0, area = 0.0;
    for (const Fillet& f : fillets_of(piece.profile, unit_mm)) {
        const Vec2 out = -1.0 * left_normal(f.d1);
        for (int k = 0; k < kAlong; ++k) {
            const SinCos a = sin_cos((k + 0.5) * f.turn_degrees / kAlong);
            const Vec2 n = a.cos * out + a.sin * left_normal(out);
            if (n.y >= 0) break;
            const double seen = n.y * n.y * n.y * n.y;
            const double weight = seen * f.turn_degrees * f.rho * (f.centre.x + f.rho * n.x);
            double mean = 0.0;
            for (std::size_t i = 0; i < kAround; ++i) {
                double reach = -std::numeric_limits<double>::infinity();
                for (const Ring& ring : rings) {
                    reach = std::max(
                        reach, n.x * static_cast<double>(ring.scale) * reaches[ring.polygon][i] +
                                   n.y * static_cast<double>(ring.height));
                }
                mean += reach / kAround;
            }
            sum += weight * (mean - dot(n, f.centre) - f.rho);
            area += weight;
        }
    }
    return area > 0 ? sum / area : 0.0;
}

}  // namespace ncsim::toolpath
