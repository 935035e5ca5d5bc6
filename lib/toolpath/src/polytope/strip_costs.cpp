// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost of the facets between two rings.
#include "polytope/strip_costs.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace ncsim::toolpath {

// Fair tools cut parts that are written. Circumscribed tools mostly decide contacts; for
// circumscribed tools, the number of facets counts, and edges decide between equal numbers.
StripCosts::StripCosts(const std::vector<RingPolygon>& family, Side side,
                       bool seeks_short_directions)
    : family_(family), seeks_short_directions_(seeks_short_directions) {
    if (!seeks_short_directions || side == Side::Inscribed) return;
    long_direction_ = side == Side::Fair ? 1.0 : 1.0 / 16;
    visible_turn_ = side == Side::Fair ? 6.0 : 0.5;
}

int StripCosts::facets(const Ring& below, const Ring& above) const {
    const int sides = family_[below.polygon].sides, other_sides = family_[above.polygon].sides;
    if (below.scale == 0) return above.scale == 0 ? 0 : other_sides;
    return above.scale == 0 ? sides : facets_between(sides, other_sides);
}

double StripCosts::strip(const Ring& below, const Ring& above) const {
    const int edges = facets(below, above);  // The numbers of edges and of facets are equal.
    if (!seeks_short_directions_) return edges;
    const double long_edges = has_short_directions(below, above) ? 0.0 : edges;
    const Vec2 along =
        normalized(Vec2{static_cast<double>(above.scale) * family_[above.polygon].inner -
                            static_cast<double>(below.scale) * family_[below.polygon].inner,
                        static_cast<double>(above.height - below.height)});
    // Around the axis the normals of the strip turn by 2π sin φ, where φ is the angle of its slope.
    const double turn = 2 * std::numbers::pi * std::abs(along.y);
    return edges + long_direction_ * long_edges + visible(along, turn);
}

double StripCosts::visible(Vec2 along, double turn) const {
    if (along.x <= 0) return 0.0;  // no finished part shows the upper side
    return visible_turn_ * along.x * along.x * along.x * along.x * turn;
}

bool StripCosts::has_short_directions(const Ring& below, const Ring& above) const {
    const auto& [x, y] = family_[below.polygon].corners[0];
    const auto& [u, v] = family_[above.polygon].corners[0];
    const std::int64_t dx = above.scale * u - below.scale * x;
    const std::int64_t dy = above.scale * v - below.scale * y;
    const std::int64_t dz = above.height - below.height;
    const auto common = static_cast<double>(std::gcd(scale_step(below, above), dz));
    if (dx == 0 && dy == 0) return true;
    const double x2 = static_cast<double>(dx) * static_cast<double>(dx);
    const double y2 = static_cast<double>(dy) * static_cast<double>(dy);
    const double z2 = static_cast<double>(dz) * static_cast<double>(dz);
    return std::sqrt(x2 + y2 + z2) <= kShortDirection * common;
}

std::int64_t StripCosts::scale_step(const Ring& below, const Ring& above) {
    const bool is_cone = below.polygon == above.polygon || below.scale == 0 || above.scale == 0;
    return is_cone ? std::abs(above.scale - below.scale) : std::gcd(above.scale, below.scale);
}

}  // namespace ncsim::toolpath
