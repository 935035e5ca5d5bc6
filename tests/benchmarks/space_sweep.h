// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of two convex polytopes by a space sweep: Hertel, Mäntylä, Mehlhorn, Nievergelt,
// "Space sweep solves intersection of convex polyhedra", Acta Informatica 21 (1984), as the thesis
// tells it (4.1), which did not build it. And what it does not tell: how often its cases are
// special.
#pragma once

#include "ncsim/cda/polytope.h"

#include <cstdint>
#include <optional>

namespace ncsim::bench {

struct SpaceSweep {
    enum class Outcome : std::uint8_t {
        Found,
        Empty,    ///< They have no point in common.
        Special,  ///< Not in general position: the method does not say what then.
    };
    Outcome outcome = Outcome::Empty;
    std::optional<cda::ConvexPolytope> body;  ///< Where it was found.
};

/// A plane goes down along z; of both polytopes, edges and facets that it meets are kept, the
/// crowns; what starts is met with the crown of the other. It finds all corners of all contours in
/// which the surfaces cross, not one for each to go on from: crowns are arrays and not balanced
/// trees, for these polytopes have some dozens of facets. Decisions are exact. O(edges · crown).
/// Throws std::logic_error if contours do not close.
SpaceSweep sweep_intersection(const cda::ConvexPolytope& a, const cda::ConvexPolytope& b);

/// How two polytopes lie to each other where that is special, found by looking at all corners,
/// edges and facets of both, exactly.
struct SpecialPosition {
    bool equal = false;                ///< All facets.
    bool facets_one_side = false;      ///< Facets in one plane have an area in common …
    bool facets_face_to_face = false;  ///< … the bodies being on opposite sides of it.
    bool corner_on_surface = false;    ///< A corner of one lies on the surface of the other.
    bool edge_on_edge = false;         ///< Edges cross between their corners.

    /// Are they not in general position? Facets in one plane have corners on or edges across each
    /// other.
    bool any() const { return corner_on_surface || edge_on_edge; }
};

SpecialPosition special_position(const cda::ConvexPolytope& a, const cda::ConvexPolytope& b);

}  // namespace ncsim::bench
