// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seidel's randomised incremental linear programming in three dimensions. If a new halfspace cuts
// off the optimum, a program with one dimension less is solved.
// Source: Seidel, Small-dimensional linear programming and convex hulls made easy, 1991; thesis
// section 4.3, algorithm 3.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>
#include <optional>
#include <span>

namespace ncsim::cda {

/// The halfspace normal · x <= distance, with a normal of length 1.
struct Halfspace {
    Vec3 normal;
    double distance = 0.0;
};

/// Returns the point in `start` and all halfspaces that lies farthest in direction `objective`;
/// empty if no point does, up to rounding. `seed` determines the order of the halfspaces.
/// Requires: `objective` has positive components, so that the upper corner of `start` is the first
/// optimum.
/// Cost: expected O(halfspaces).
std::optional<Vec3> farthest_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   Vec3 objective, std::uint64_t seed);

/// Returns a point well inside all halfspaces: the middle of the inner part of a ray from the
/// optimal corner into the cone of the planes at the corner (thesis figure 4.8). Empty if the ray
/// has no inner part: the intersection is flat or nearly flat, or the corner is degenerate (try a
/// second seed).
std::optional<Vec3> interior_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   std::uint64_t seed);

}  // namespace ncsim::cda
