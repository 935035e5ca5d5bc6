// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounded corners of a profile, in lattice units: x is the distance from the axis, y the height.
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/toolpath/tool.h"

#include <cstddef>
#include <vector>

namespace ncsim::toolpath {

/// A rounded corner: the disc of radius rho about `centre` touches the line along d1 at `start` and
/// the line along d2 at `end`.
struct Fillet {
    Vec2 centre, start, end, d1, d2;
    double rho = 0.0;
    double turn_degrees = 0.0;

    /// Returns the angle from d1 to `d`, degrees.
    double angle_to(Vec2 d) const;
    /// Returns the intersection of the line from `from` along `d` and the line along d2.
    Vec2 meet_end_line(Vec2 from, Vec2 d) const;
};

/// Returns the corner between the points `before` and `after` with the radius `rho`.
Fillet fillet_of(Vec2 before, Vec2 corner, Vec2 after, double rho);
/// Returns the rounded corners of `profile`.
std::vector<Fillet> fillets_of(const std::vector<ProfilePoint>& profile, double unit_mm);

/// Converts the points of `profile` to lattice units.
std::vector<Vec2> corners_of(const std::vector<ProfilePoint>& profile, double unit_mm);
/// Returns the neighbour of corner `i` below. Discs close the profile, so the first and the last
/// line start on the axis.
Vec2 previous_point(const std::vector<Vec2>& points, std::size_t i);
/// Returns the neighbour of corner `i` above.
Vec2 next_point(const std::vector<Vec2>& points, std::size_t i);

}  // namespace ncsim::toolpath
