// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two convex bodies, each told by points that it is the hull of: do they keep a distance, or do
// they have volume in common? Doubles propose, integers decide. Between the two answers, within
// what 24 bits of a normal can tell (6 nm over 100 mm), both may be no.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// How near two convex bodies come. In lattice units.
struct Nearness {
    /// Proven: a slab of the width that was asked for lies between them.
    bool is_apart = false;
    /// Of two points, one of each: they are no farther apart. Unless is_apart, the least there is,
    /// up to rounding of doubles; 0 where they meet.
    double distance = 0.0;
    Vec3 way;  ///< From the first to the second, of any length: a hint for the next question.
};

/// Lies a slab of at least `width` units between the hulls of `a` and `b`? For 0 a plane does, so
/// that they touch at most. Coordinates up to 2^36 units; `width` is not negative; `hint` is where
/// to look first, or 0.
///
/// Source: Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between
/// complex objects in three-dimensional space", IEEE Journal of Robotics and Automation 4, 1988.
/// A few passes over all points.
Nearness nearness(std::span<const LatticePoint> a, std::span<const LatticePoint> b,
                  std::int64_t width, Vec3 hint = {});

/// A point strictly inside both hulls, exactly, and at least `margin` units inside of their facets;
/// nothing if there is none, or no more room for one than 24 bits of a normal can tell. In units.
/// Each hull is of less than 2^24 units an axis.
std::optional<Vec3> common_point(std::span<const LatticePoint> a, std::span<const LatticePoint> b,
                                 std::int64_t margin);

/// Across which a convex body may be left: unit normals of its facets, and directions of its edges,
/// of which parallel ones stand once.
struct Directions {
    std::vector<Vec3> normals, edges;
};
Directions directions_of(const ConvexPolytope& body);

/// How far one of two convex bodies that meet has to be moved for them to touch at most: the least
/// of all facets of their Minkowski difference. In doubles, in the unit of the corners; 0 where
/// they do not meet. O(edges of a · edges of b · corners).
///
/// Source: Gottschalk, "Separating axis theorem", TR96-024, University of North Carolina, 1996.
double depth(std::span<const Vec3> a, const Directions& of_a, std::span<const Vec3> b,
             const Directions& of_b);

}  // namespace ncsim::cda
