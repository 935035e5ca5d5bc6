// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seidel's randomised incremental linear programming in three dimensions, which goes down to two
// and to one where a new halfspace cuts the optimum off. Seidel, Small-dimensional linear
// programming and convex hulls made easy, 1991; thesis section 4.3, algorithm 3.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstdint>
#include <optional>
#include <span>

namespace ncsim::cda {

/// normal · x <= distance, normal of length 1.
struct Halfspace {
    Vec3 normal;
    double distance = 0.0;
};

/// The point of all halfspaces that lies farthest in direction `objective`, a corner of `start`
/// where no halfspace forbids it; nothing where there is no such point, up to rounding. `objective`
/// must have positive components: the upper corner of `start` is then optimal to begin with. The
/// order of the halfspaces is shuffled by `seed`. Expected O(halfspaces).
std::optional<Vec3> farthest_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   Vec3 objective, std::uint64_t seed);

/// A point well inside all halfspaces: from the optimal corner into the cone of the planes that
/// meet there, to the middle of what the ray has inside (thesis figure 4.8). Nothing where the
/// ray has no inside: the intersection is flat or nearly so, or the corner is degenerate (try
/// another seed).
std::optional<Vec3> interior_point(std::span<const Halfspace> halfspaces, const Box& start,
                                   std::uint64_t seed);

}  // namespace ncsim::cda
