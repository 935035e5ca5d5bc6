// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of a part from three of its points.
#pragma once

#include "ncsim/base/vec3.h"

#include <array>
#include <string>

namespace ncsim::setup {

/// A rotation as text of parse_any_turn(), followed by a translation in mm.
struct TurnAndMove {
    std::string turn;
    Vec3 move{};
};

/// Largest difference, mm, of a distance between two points before and now.
inline constexpr double kPointTolerance = 0.01;

/// Returns the motion that moves the point `before[0]` to `now[0]`, the line to `before[1]` to that
/// to `now[1]`, and the third point to the plane and side of `now[2]`. Coordinates are in mm.
/// Angles within 1e-6 degrees of a right angle are right angles. Throws: std::invalid_argument if
/// the points are on a line, or if a distance differs by more than kPointTolerance.
TurnAndMove motion_of(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& now);

}  // namespace ncsim::setup
