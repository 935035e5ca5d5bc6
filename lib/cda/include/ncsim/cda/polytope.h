// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polytopes with exact corners, the vertex representation of a set of halfspaces.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::cda {

/// A full-dimensional polytope. Facets are irredundant, one per plane. Facets share corners, and no
/// corner occurs twice.
class ConvexPolytope {
public:
    /// Facet, with its corners and the facets across its edges.
    struct Facet {
        Plane plane;
        std::vector<std::uint32_t> vertices;  ///< Counter-clockwise seen from outside.
        /// neighbours[i] is the facet across the edge vertices[i] → vertices[i+1].
        std::vector<std::uint32_t> neighbours;
    };

    /// Returns the polytope of a cell; empty if the cell is flat or empty. Requires: a bounded cell
    /// within the range of the lattice (the stock). For other cells, clip() the stock.
    static std::optional<ConvexPolytope> of(const Cell& cell, const Lattice& lattice);

    /// Builds a polytope from facets with matching edges, the result of another algorithm. Facets
    /// without corners are dropped. See is_consistent().
    static ConvexPolytope assemble(std::vector<ExactPoint> vertices, std::vector<Facet> facets);

    const std::vector<ExactPoint>& vertices() const { return vertices_; }
    const std::vector<Facet>& facets() const { return facets_; }
    /// Returns a closed box around the polytope, in lattice units.
    const Box& bounds() const { return bounds_; }

    /// Returns the facet in `plane` with the same orientation, if any. Cost: O(facets).
    std::optional<std::uint32_t> facet_in(const Plane& plane) const;

    /// Returns the part below `plane`; empty if the part has no volume. Exact.
    /// Cost: O(corners).
    std::optional<ConvexPolytope> clip(const Plane& plane) const;
    /// Returns the part below all of `planes`.
    std::optional<ConvexPolytope> clip(const std::vector<Plane>& planes) const;

    /// Returns the volume in cubic lattice units. The relative error is a few 2^-53 times the
    /// number of facets.
    double volume() const;

    /// True if every corner is below or on every facet's plane and exactly on the planes of the
    /// corner's facets, and every edge is between two facets. Then the facets bound exactly the
    /// intersection of the halfspaces.
    bool is_consistent() const;

private:
    void update_bounds();
    std::vector<ExactPoint> vertices_;
    std::vector<Facet> facets_;
    Box bounds_;
};

/// Returns exactly how a box lies to a plane of any distance: Below or Above if the whole box does
/// or touches the plane from that side, On if the plane cuts the box.
Side classify_box(const Box& box_units, const Plane& plane);

}  // namespace ncsim::cda
