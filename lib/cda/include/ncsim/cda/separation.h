// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distance and overlap of two convex bodies, each given as the hull of points. Doubles propose a
// certificate, integers verify the certificate. Within the resolution of 24-bit normals (6 nm over
// 100 mm) neither a distance nor a common volume may be provable.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/polytope.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Distance of two convex bodies, in lattice units.
struct BodyDistance {
    /// Proven: a slab of the requested width lies between the bodies.
    bool is_apart = false;
    /// Upper bound of the distance: the distance of two points, one per body. Unless `is_apart`,
    /// this is the distance of the bodies up to rounding of doubles; 0 if the bodies meet.
    double distance = 0.0;
    Vec3 way;  ///< Vector from the first body to the second, any length: hint for the next call.
};

/// Decides if a slab of at least `width` units lies between the hulls of `a` and `b`. For width 0 a
/// plane suffices, so that the hulls touch at most. `hint` is the direction to try first, or 0.
/// Requires: coordinates up to 2^36 units; `width` is not negative.
/// Cost: a few passes over all points.
/// Source: Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between
/// complex objects in three-dimensional space", IEEE Journal of Robotics and Automation 4, 1988.
BodyDistance body_distance(std::span<const LatticePoint> a, std::span<const LatticePoint> b,
                           std::int64_t width, Vec3 hint = {});

/// Returns a point (in units) that is exactly strictly inside both hulls and at least `margin`
/// units inside of their facets; empty if no such point exists, or if the space for one is below
/// the resolution of 24-bit normals.
/// Requires: each hull extends over less than 2^24 units per axis.
std::optional<Vec3> common_point(std::span<const LatticePoint> a, std::span<const LatticePoint> b,
                                 std::int64_t margin);

/// Candidates for separating directions of a convex body: unit normals of facets and directions of
/// edges, without parallel duplicates.
struct Directions {
    std::vector<Vec3> normals, edges;
};
Directions directions_of(const ConvexPolytope& body);
/// Returns the normals and edge directions of a polytope.

/// Returns the length of the shortest translation after which two convex bodies touch at most: the
/// minimum over all facets of the Minkowski difference. In doubles, in the unit of the corners; 0
/// if the bodies do not meet.
/// Cost: O(edges of a · edges of b · corners).
/// Source: Gottschalk, "Separating axis theorem", TR96-024, University of North Carolina, 1996.
double depth(std::span<const Vec3> a, const Directions& of_a, std::span<const Vec3> b,
             const Directions& of_b);

}  // namespace ncsim::cda
