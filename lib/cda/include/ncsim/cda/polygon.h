// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane, with exact corners: facets, and what is left of them.
#pragma once

#include "ncsim/cda/polytope.h"
#include "ncsim/cda/predicates.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A convex polygon with area. Its corners are counter-clockwise seen from above `plane`; edges[i]
/// is the plane that cuts the edge corners[i] → corners[i+1] out of it, the polygon being below.
struct ConvexPolygon {
    Plane plane;
    std::vector<ExactPoint> corners;
    std::vector<Plane> edges;

    static ConvexPolygon of_facet(const ConvexPolytope& polytope, std::uint32_t facet);
};

/// What lies below `cut`; nothing if that has no area. `cut` must not be parallel to the polygon.
/// Exact.
std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, const Plane& cut);

/// What lies below all of `cuts`.
std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, std::span<const Plane> cuts);

/// What a polygon has in common with the points below all of `cuts`, as far as single cuts tell.
enum class Overlap : std::uint8_t {
    None,       ///< No area: one cut has all of it above.
    Covered,    ///< All of it.
    Undecided,  ///< Some cuts cross it.
};

/// `crossing` receives the cuts that have parts of the polygon on both sides, where Undecided.
/// O(cuts · corners).
Overlap overlap(const ConvexPolygon& polygon, std::span<const Plane> cuts,
                std::vector<Plane>& crossing);

/// polygon \ {points below all of `cuts`}, as convex polygons without common inner points,
/// appended to `rest`. A polygon that loses no area is appended whole. O(cuts · corners).
void subtract(const ConvexPolygon& polygon, std::span<const Plane> cuts,
              std::vector<ConvexPolygon>& rest);

/// The same polygon seen from the other side of its plane.
ConvexPolygon turned_over(const ConvexPolygon& polygon);

/// In square lattice units.
double area(const ConvexPolygon& polygon);

}  // namespace ncsim::cda
