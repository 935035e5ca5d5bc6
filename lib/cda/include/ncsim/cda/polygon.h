// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons in a plane with exact corners: facets and remainders of facets.
#pragma once

#include "ncsim/cda/polytope.h"
#include "ncsim/cda/predicates.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A convex polygon with area. The corners are counter-clockwise seen from above `plane`. edges[i]
/// is the plane that bounds the polygon along corners[i] → corners[i+1]; the polygon lies below
/// edges[i].
struct ConvexPolygon {
    Plane plane;
    std::vector<ExactPoint> corners;
    std::vector<Plane> edges;

    static ConvexPolygon of_facet(const ConvexPolytope& polytope, std::uint32_t facet);
};

/// Returns the part below `cut`; empty if the part has no area. Exact.
/// Requires: `cut` is not parallel to the polygon.
std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, const Plane& cut);

/// Returns the part below all of `cuts`.
std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, std::span<const Plane> cuts);

/// Relation of a polygon to the points below all of `cuts`, as far as single cuts decide.
enum class Overlap : std::uint8_t {
    None,       ///< No common area: one cut has the whole polygon above.
    Covered,    ///< The whole polygon is below all cuts.
    Undecided,  ///< Some cuts cross the polygon.
};

/// Decides how `polygon` lies to the cuts. If Undecided, `crossing` receives the cuts that have
/// parts of the polygon on both sides.
/// Cost: O(cuts · corners).
Overlap overlap(const ConvexPolygon& polygon, std::span<const Plane> cuts,
                std::vector<Plane>& crossing);

/// Appends polygon \ {points below all of `cuts`} to `rest`, as convex polygons without common
/// inner points. A polygon that loses no area is appended whole.
/// Cost: O(cuts · corners).
void subtract(const ConvexPolygon& polygon, std::span<const Plane> cuts,
              std::vector<ConvexPolygon>& rest);

/// Returns the same polygon seen from the opposite side of the plane.
ConvexPolygon reversed(const ConvexPolygon& polygon);

/// Returns the area in square lattice units.
double area(const ConvexPolygon& polygon);

}  // namespace ncsim::cda
