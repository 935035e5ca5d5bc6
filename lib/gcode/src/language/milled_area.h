// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines of the areas that pocket, slot and stud cycles mill.
#pragma once

#include "control/cycles/outline.h"

#include <vector>

namespace ncsim::gcode::language {

/// An area in the plane, active units: a rectangle with round corners (also a circle, a slot), a
/// band about an arc (a circular slot), or a regular polygon with round corners.
struct MilledArea {
    Vec2 centre;              ///< Centre of the rectangle or the arc.
    double angle = 0.0;       ///< Degrees: direction of the length, or of the start of the band.
    double length = 0.0;      ///< Length of the rectangle.
    double width = 0.0;       ///< Width of the rectangle or the band.
    double corner = 0.0;      ///< Radius of the corners.
    double arc_radius = 0.0;  ///< Radius of the centre line of the band; 0: a rectangle.
    double opening = 0.0;     ///< Angle of the band, degrees, > 0.
    /// Sides of a polygon, at least 3; 0: no polygon. `length` and `width` are the diameter of the
    /// inscribed circle; a corner is in the direction of `angle`.
    int sides = 0;

    bool is_polygon() const { return sides > 0; }
    bool is_band() const { return arc_radius > 0.0; }
    /// Half of the smaller width.
    double half_width() const;
    /// Distance between the centre and the outline in the direction of `angle`.
    double reach() const;
};

/// Moves that follow each other.
using Pass = std::vector<OutlineMove>;

/// Returns the outline at the distance `inset` inside the area (negative: outside),
/// counter-clockwise, from the middle of the side in the direction of the angle (of a band: from
/// the middle of the outer side; of a polygon: from the middle of the corner).
/// Requires: `inset` < area.half_width().
Pass outline_of(const MilledArea& area, double inset);
/// Returns the middle of the area.
Vec2 middle_of(const MilledArea& area);
/// Returns the moves from the middle along the centre line to one end, to the other end, and back
/// to the middle; empty for a circle or a square.
Pass centre_line_of(const MilledArea& area);
/// Reverses the order and the direction of the moves.
void reverse(Pass& pass);
/// Returns the point at `x` and `y` from the centre of the area, in the directions of its sides.
Vec2 point_in(const MilledArea& area, double x, double y);

}  // namespace ncsim::gcode::language
