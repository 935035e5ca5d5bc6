// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test on the map of a face whether loops cross or touch. mm.
#pragma once

#include "ncsim/brep/curve.h"

#include "query/face_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Piece of an edge on the map: a chord, and the distance of the curve from the chord.
struct MapSegment {
    Vec2 a, b;
    std::uint64_t from, to;  ///< Names of the ends; adjacent segments have a common name.
    const Track* track;      ///< Edge of which the segment is a chord, between `begin` and `end`.
    double begin, end;
    bool is_straight;  ///< Also on the map.
    std::uint32_t edge;

    /// Bound of the distance between chord and curve. A piece of 4 degrees is off by a hundredth of
    /// the length; the map may bend pieces more.
    double deviation = is_straight ? 0.0 : 0.1 * length();

    double length() const {
        return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    }
    double low() const { return std::min(a.y, b.y) - deviation; }
    double high() const { return std::max(a.y, b.y) + deviation; }
    double left() const { return std::min(a.x, b.x) - deviation; }
    double right() const { return std::max(a.x, b.x) + deviation; }
};

/// Returns the edges of two segments that cross or come within `clear` of each other.
/// Cost: O(n log n) for n evenly distributed segments.
std::optional<std::array<std::uint32_t, 2>> any_interfere(const FaceMap& map,
                                                          std::vector<MapSegment> segments,
                                                          double clear);

/// Returns the rounds, by their index, that come within `clear` of another round or of a segment.
/// Cost: O(n log n) for n evenly distributed rounds and segments.
std::vector<std::size_t> rounds_near_others(const std::vector<FaceMap::Round>& rounds,
                                            const std::vector<MapSegment>& segments, double clear);

}  // namespace ncsim::brep
