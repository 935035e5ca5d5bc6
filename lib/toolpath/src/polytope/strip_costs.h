// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost of the facets between two rings of a polytope.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/toolpath/side.h"

#include "polytope/ring_polygon.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::toolpath {

/// Largest length of a short edge direction, in units, after division by the common factor of its
/// components. The walls of a tool that moves by t have normals e × t for edge directions e. If |e|
/// |t| < 2^24 (cda::kNormalBits), these normals are exact, and the walls of successive moves meet
/// in the edge. Rounded normals leave slivers of nanometres along each edge. 1,400 suffices for
/// moves up to 12 mm with three decimals.
inline constexpr double kShortDirection = 1400.0;

/// A horizontal section of the polytope.
struct Ring {
    std::size_t polygon = 0;  ///< index in the family
    std::int64_t scale = 0;   ///< multiple of the polygon; 0 for a tip
    std::int64_t height = 0;
};

/// Costs of strips between rings, in facets.
class StripCosts {
public:
    /// `seeks_short_directions`: edges with long directions, and gentle slopes, cost more.
    /// Requires: `family` outlives this object.
    StripCosts(const std::vector<RingPolygon>& family, Side side, bool seeks_short_directions);

    /// Makes gentle slopes cost no more than steep slopes.
    void ignore_slopes() { visible_turn_ = 0.0; }
    /// Makes only facets count.
    void count_facets_only() { long_direction_ = visible_turn_ = 0.0; }

    /// Returns the cost of the strip between two rings.
    double strip(const Ring& below, const Ring& above) const;
    /// Returns the cost of an angle (radians) between normals at the slope `along`.
    double visible(Vec2 along, double turn) const;
    /// True if the edges between two rings have short directions. Decided by one edge, because the
    /// lengths differ little.
    bool has_short_directions(const Ring& below, const Ring& above) const;
    /// Returns the common factor of the horizontal components of all edges between two rings.
    static std::int64_t scale_step(const Ring& below, const Ring& above);

private:
    int facets(const Ring& below, const Ring& above) const;

    const std::vector<RingPolygon>& family_;
    bool seeks_short_directions_;
    double long_direction_ = 0.0;  // an edge with a long direction
    // A radian between the normals of two facets at the tip. At other slopes the fourth power of
    // the cosine between normal and axis is a factor (mean_excess).
    double visible_turn_ = 0.0;
};

}  // namespace ncsim::toolpath
