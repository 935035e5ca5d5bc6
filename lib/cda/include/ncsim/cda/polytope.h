// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polytopes with exact corners: what a set of halfspaces looks like.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::cda {

/// A full-dimensional polytope. Facets are irredundant, one per plane; corners are
/// shared and each stands once.
class ConvexPolytope {
public:
    struct Facet {
        Plane plane;
        std::vector<std::uint32_t> vertices;  ///< Counter-clockwise seen from outside.
        /// neighbours[i] is the facet across the edge vertices[i] → vertices[i+1].
        std::vector<std::uint32_t> neighbours;
    };

    /// The polytope of a cell. Nothing if it is flat or empty. Requires a bounded cell within the
    /// range of the lattice (the stock; other cells are cut out of it with clip()).
    static std::optional<ConvexPolytope> of(const Cell& cell, const Lattice& lattice);

    /// From facets whose edges are known to match: what another algorithm found. Facets
    /// without corners are dropped. See is_consistent().
    static ConvexPolytope assemble(std::vector<ExactPoint> vertices, std::vector<Facet> facets);

    const std::vector<ExactPoint>& vertices() const { return vertices_; }
    const std::vector<Facet>& facets() const { return facets_; }
    /// Encloses the polytope; in lattice units, closed.
    const Box& bounds() const { return bounds_; }

    /// The facet in `plane` (same orientation), if there is one. O(facets).
    std::optional<std::uint32_t> facet_in(const Plane& plane) const;

    /// What lies below `plane`: nothing if no part with volume does. Exact. `cuts`, where given,
    /// counts the planes that really cut. O(corners).
    std::optional<ConvexPolytope> clip(const Plane& plane) const;
    /// What lies below all of `planes`.
    std::optional<ConvexPolytope> clip(const std::vector<Plane>& planes) const;

    /// In lattice units cubed. Relative error a few 2^-53 times the number of facets.
    double volume() const;

    /// Every corner below or on every facet's plane and exactly on its own, every edge between
    /// two facets: then the facets bound exactly the intersection of their halfspaces.
    bool is_consistent() const;

private:
    void update_bounds();
    std::vector<ExactPoint> vertices_;
    std::vector<Facet> facets_;
    Box bounds_;
};

/// How a box lies to a plane, exactly: Below or Above if all of it does or touches the plane from
/// there, On if it is cut. For planes of any distance.
Side classify_box(const Box& box_units, const Plane& plane);

}  // namespace ncsim::cda
