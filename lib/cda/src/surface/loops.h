// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of points in a plane: which way they run, what they surround. Doubles first, rational
// numbers where those cannot tell.
#pragma once

#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <functional>
#include <span>

namespace ncsim::cda {

/// The points that loops are made of, by number.
struct LoopPoints {
    /// Lattice units, off by kLoopPointError an axis at most.
    std::function<Vec3(std::uint32_t)> approx;
    std::function<ExactPoint(std::uint32_t)> exact;
};
inline constexpr double kLoopPointError = 1e-7;

/// 1: the loop runs counter-clockwise seen from above the plane of its points; -1: clockwise; 0: it
/// has no area. O(points).
int orientation(std::span<const std::uint32_t> loop, const Plane& plane, const LoopPoints& points);

/// Is the middle of the segment from `tail` to `head`, which is not on the loop, inside of it? All
/// in one plane. O(points).
bool surrounds(std::span<const std::uint32_t> loop, std::uint32_t tail, std::uint32_t head,
               const Plane& plane, const LoopPoints& points);

}  // namespace ncsim::cda
