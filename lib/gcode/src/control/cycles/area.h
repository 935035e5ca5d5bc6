// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the centre of a round cutter may be inside a closed outline, and strokes that cover it.
#pragma once

#include <vector>

namespace ncsim::gcode {

/// In the plane, in any unit of length.
struct PlanePoint {
    double x = 0.0, y = 0.0;
};

/// From `from` to `to` along the first coordinate.
struct Stroke {
    double from = 0.0, to = 0.0;
};

/// What lies inside a polygon, not nearer to it than a distance.
class Area {
public:
    /// `outline` is closed by itself and does not cross itself; either sense.
    Area(std::vector<PlanePoint> outline, double distance);

    bool contains(PlanePoint p) const;
    /// All between two places of the area? Cost: all sides of the outline.
    bool contains(PlanePoint a, PlanePoint b) const;
    /// The pieces of the line y = `y` in the area, from left to right. Cost as above, sorted.
    std::vector<Stroke> strokes_at(double y) const;

    // Nothing of the area lies below or above; empty if `lowest` is above `highest`.
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }

private:
    std::vector<PlanePoint> outline_;
    // A little less than it was said to be: what is at it counts as far enough. A stroke ends
    // nearer to it than ways may come, so that ways along an edge are ways.
    double of_strokes_, of_ways_;
    double lowest_ = 0.0, highest_ = 0.0;
};

/// Above 0 where the outline runs counter-clockwise.
double signed_area(const std::vector<PlanePoint>& outline);

}  // namespace ncsim::gcode
