// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed outlines of lines and arcs in the plane.
#pragma once

#include "control/cycles/area.h"

#include <vector>

namespace ncsim::gcode {

/// A move of an outline in the plane. `turns` = 0: a line; otherwise an arc about `centre`.
struct OutlineMove {
    Vec2 from, to, centre;
    int turns = 0;  ///< > 0 counter-clockwise, < 0 clockwise.
};

/// Returns the point of `move` after the share `share` of its length.
Vec2 point_at(const OutlineMove& move, double share);
/// Returns the direction of `move` at its point after half of the length, not normalized.
Vec2 direction_in_middle(const OutlineMove& move);
/// Returns the outline as a polygon with the chord tolerance `chord`.
std::vector<Vec2> polygon_of(const std::vector<OutlineMove>& outline, double chord);

}  // namespace ncsim::gcode
