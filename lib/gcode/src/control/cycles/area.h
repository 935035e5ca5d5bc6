// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region inside closed outlines where the centre of a round cutter may be, and strokes that
// cover the region.
#pragma once

#include "ncsim/base/vec2.h"

#include <vector>

namespace ncsim::gcode {

/// A segment from `from` to `to` along the first coordinate.
struct Stroke {
    double from = 0.0, to = 0.0;
};

/// Points inside an odd number of polygons whose distance from all polygons is at least a given
/// distance.
class Area {
public:
    /// The outlines are closed implicitly, do not intersect, and have any orientation. `distance`
    /// ≥ 0.
    Area(const std::vector<std::vector<Vec2>>& outlines, double distance);

    /// True if `p` is in the area.
    /// Cost: O(sides of the outlines).
    bool contains(Vec2 p) const;
    /// True if the whole segment between two points of the area is in the area.
    /// Cost: O(sides of the outlines).
    bool contains(Vec2 a, Vec2 b) const;
    /// Returns the segments of the line y = `y` in the area, from left to right.
    /// Cost: O(n log n + n k) for n sides of the outlines and k segments.
    std::vector<Stroke> strokes_at(double y) const;

    // Bounds of the second coordinate of the area; the area is empty if `lowest` > `highest`.
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }

private:
    struct Side {
        Vec2 a, b;
    };
    std::vector<Side> sides_;
    // `distance` minus a rounding tolerance, so points at exactly `distance` count as inside.
    // path_margin_ < of_strokes_, so a connection between ends of strokes along an edge of the area
    // is inside.
    double of_strokes_, path_margin_;
    double lowest_ = 0.0, highest_ = 0.0;
};

/// Returns the area enclosed by `outline`; > 0 if `outline` is counter-clockwise.
double signed_area(const std::vector<Vec2>& outline);

}  // namespace ncsim::gcode
