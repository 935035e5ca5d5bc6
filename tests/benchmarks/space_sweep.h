// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of two convex polytopes by a space sweep, which the thesis describes (4.1) but does
// not implement. Also tests for special position; the thesis does not state how often that occurs.
// Source: Hertel, Mäntylä, Mehlhorn, Nievergelt, "Space sweep solves intersection of convex
// polyhedra", Acta Informatica 21 (1984).
#pragma once

#include "ncsim/cda/polytope.h"

#include <cstdint>
#include <optional>

namespace ncsim::bench {

struct SpaceSweep {
    enum class Outcome : std::uint8_t {
        Found,
        Empty,    ///< The polytopes have no common point.
        Special,  ///< Not in general position: the method defines no result.
    };
    Outcome outcome = Outcome::Empty;
    std::optional<cda::ConvexPolytope> body;  ///< Set if `outcome` is Found.
};

/// Intersects two polytopes. A plane moves down along z; the crown of a polytope is the set of
/// edges and facets that the plane meets. Each starting edge or facet is tested with the crown of
/// the second polytope. This finds all corners of all contours in which the surfaces cross, not a
/// single corner per contour. Crowns are arrays and not balanced trees, because these polytopes
/// have some dozens of facets. Decisions are exact.
/// Cost: O(edges · crown).
/// Throws: std::logic_error if contours do not close.
SpaceSweep sweep_intersection(const cda::ConvexPolytope& a, const cda::ConvexPolytope& b);

/// Special position of two polytopes, found by exact tests of all corners, edges and facets.
struct SpecialPosition {
    bool equal = false;                ///< All facets are equal.
    bool facets_one_side = false;      ///< Facets in a common plane overlap, with the bodies on the
                                       ///< same side.
    bool facets_face_to_face = false;  ///< Facets in a common plane overlap, with the bodies on
                                       ///< opposite sides.
    bool corner_on_surface = false;    ///< A corner lies on the surface of the second polytope.
    bool edge_on_edge = false;         ///< Edges cross between their corners.

    /// True if the polytopes are not in general position. Facets that overlap in a common plane
    /// have corners on each other or edges across each other.
    bool any() const { return corner_on_surface || edge_on_edge; }
};

SpecialPosition special_position(const cda::ConvexPolytope& a, const cda::ConvexPolytope& b);

}  // namespace ncsim::bench
