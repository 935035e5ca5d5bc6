// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of points in a plane: orientation and containment. A filter in doubles decides first,
// rational numbers otherwise.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"

#include <cstdint>
#include <functional>
#include <span>

namespace ncsim::cda {

/// The points of loops, by number.
struct LoopPoints {
    /// Lattice units; the error is at most kLoopPointError per axis.
    std::function<Vec3(std::uint32_t)> approx;
    std::function<ExactPoint(std::uint32_t)> exact;
};
inline constexpr double kLoopPointError = 1e-7;

/// Returns 1 if the loop is counter-clockwise seen from above the plane, -1 if clockwise, 0 if the
/// loop has no area.
/// Cost: O(points).
int orientation(std::span<const std::uint32_t> loop, const Plane& plane, const LoopPoints& points);

/// True if the middle of the segment from `tail` to `head` is inside the loop.
/// Requires: the middle is not on the loop; all points are in one plane.
/// Cost: O(points).
bool surrounds(std::span<const std::uint32_t> loop, std::uint32_t tail, std::uint32_t head,
               const Plane& plane, const LoopPoints& points);

}  // namespace ncsim::cda
