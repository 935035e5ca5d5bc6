// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arc that rounds the corner between two lines or arcs of a plane.
#pragma once

#include "control/cycles/area.h"

#include <optional>

namespace ncsim::gcode {

/// A line or an arc that ends or begins at a corner.
struct PlaneElement {
    Vec2 from, to;
    bool is_arc = false;
    Vec2 centre;
    double turn = 1.0;  ///< 1: counter-clockwise, -1: clockwise.

    double radius() const;
    /// Returns the length; an arc with equal ends is a full circle.
    double length() const;
    /// Returns the unit direction at the point `p` of the element.
    Vec2 direction_at(Vec2 p) const;
    /// Returns the length from `a` to `b` along the element: negative if `b` is before `a` on a
    /// line; less than a full circle on an arc.
    double way(Vec2 a, Vec2 b) const;
    /// Returns the point of the whole line or circle that is nearest to `p`.
    Vec2 foot(Vec2 p) const;
};

/// An arc that is tangent to two elements.
struct Fillet {
    Vec2 begin, end, centre;
};

/// Returns the arc of `radius` at the corner between `first` and `second`. `side`: 1 for a left
/// turn, -1 for a right turn.
/// Requires: `first.to` is `second.from`; the directions there differ.
/// Returns: nullopt if no arc of that radius is tangent to both elements between their ends.
std::optional<Fillet> fillet(const PlaneElement& first, const PlaneElement& second, double radius,
                             double side);

}  // namespace ncsim::gcode
