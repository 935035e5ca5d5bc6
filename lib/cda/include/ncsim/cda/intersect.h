// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of two convex polytopes as in the thesis (chapter 4): the union of the halfspaces, a
// linear program for an interior point, the polar dual about this point, Quickhull, and the dual of
// the result. Each corner of the result is then checked exactly. If doubles were not sufficient,
// the polytope is cut plane by plane in integers instead.
#pragma once

#include "ncsim/cda/polytope.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::cda {

/// Returns seconds since a fixed moment. The caller passes a clock to code that is to be timed.
using Clock = double (*)();

/// Cost of intersections: the columns of thesis figures 7.1, 7.2 and 7.6.
struct IntersectionCosts {
    double linear_programming_seconds = 0.0;  ///< 0 without a clock.
    double convex_hull_seconds = 0.0;         ///< Polar dual, Quickhull and the inverse dual.
    std::uint64_t intersections = 0;
    std::uint64_t empty = 0;            ///< Flat intersections included.
    std::uint64_t exact_fallbacks = 0;  ///< Non-empty intersections that doubles could not prove.

    IntersectionCosts& operator+=(const IntersectionCosts& other);
};

/// Returns exactly the intersection; empty if the intersection has no volume. `clock` may be null.
/// Cost: expected O(n log n) in the number of facets; O(n²) for the check.
std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const ConvexPolytope& b,
                                        IntersectionCosts& costs, Clock clock = nullptr);

/// The same with a cell, which may reach far beyond the lattice: planes that do not cut the box of
/// `a` are decided by the box.
std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const Cell& cell,
                                        const Lattice& lattice, IntersectionCosts& costs,
                                        Clock clock = nullptr);

/// Returns the same polytope as intersect(), cut plane by plane. Serves as the oracle of
/// intersect().
std::optional<ConvexPolytope> intersect_exact(const ConvexPolytope& a, const ConvexPolytope& b);

/// Returns a point strictly inside both bodies, in lattice units; empty if the intersection has no
/// volume. The point is the certificate of a collision (thesis 5.2).
std::optional<Vec3> common_point(const ConvexPolytope& a, const ConvexPolytope& b);

/// Returns a point strictly inside all halfspaces, in lattice units; empty if no point is. Exact.
/// Requires: `box` contains the intersection of the halfspaces.
std::optional<Vec3> point_inside(const std::vector<Plane>& planes, const Box& box);

}  // namespace ncsim::cda
