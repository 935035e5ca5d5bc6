// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of two convex polytopes as the thesis does it (chapter 4): joint halfspaces, a
// linear program for a point inside, the polar dual about it, Quickhull, and back. What comes out
// is then checked exactly, corner by corner; where doubles were not good enough, the polytope is
// cut out plane by plane in integers instead.
#pragma once

#include "ncsim/cda/polytope.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::cda {

/// Seconds from some fixed moment; how the caller lends a clock to what is to be measured.
using Clock = double (*)();

/// What intersections cost: the columns of thesis figures 7.1, 7.2 and 7.6.
struct IntersectionCosts {
    double linear_programming_seconds = 0.0;  ///< 0 without a clock.
    double convex_hull_seconds = 0.0;         ///< Polar dual, Quickhull and the way back.
    std::uint64_t intersections = 0;
    std::uint64_t empty = 0;            ///< Flat ones too.
    std::uint64_t exact_fallbacks = 0;  ///< Not empty, but not proven by doubles.

    IntersectionCosts& operator+=(const IntersectionCosts& other);
};

/// Exactly the intersection; nothing if it has no volume. `clock` may be null. Expected
/// O(n log n) in the number of facets; the check is O(n²).
std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const ConvexPolytope& b,
                                        IntersectionCosts& costs, Clock clock = nullptr);

/// The same with a cell, which may reach far beyond the lattice: planes that do not cut the box of
/// `a` are decided there.
std::optional<ConvexPolytope> intersect(const ConvexPolytope& a, const Cell& cell,
                                        const Lattice& lattice, IntersectionCosts& costs,
                                        Clock clock = nullptr);

/// The same polytope, cut plane by plane: the oracle of the above.
std::optional<ConvexPolytope> intersect_exact(const ConvexPolytope& a, const ConvexPolytope& b);

/// A point strictly inside both, in lattice units, or nothing if their intersection has no
/// volume: the certificate of a collision (thesis 5.2).
std::optional<Vec3> common_point(const ConvexPolytope& a, const ConvexPolytope& b);

/// A point strictly inside all halfspaces, in lattice units, or nothing if there is none; `box` is
/// not smaller than what they have in common. Exact.
std::optional<Vec3> point_inside(const std::vector<Plane>& planes, const Box& box);

}  // namespace ncsim::cda
