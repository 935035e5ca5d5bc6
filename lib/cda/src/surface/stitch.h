// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stitching: from outlines of pieces of facets to a watertight boundary.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include "surface/outlines.h"

#include <memory>
#include <vector>

namespace ncsim::cda {

/// A connected piece of the surface with exact corners, in an oriented plane with the material
/// below. The piece is on the left of its loops, seen from outside the material. Pieces in the same
/// plane have no common inner points.
struct Fragment {
    struct Corner {
        ExactPoint point;  ///< On the planes of both edges that meet at the corner.
        /// A plane through the edge to the next corner, not parallel to the fragment's plane.
        Plane edge;
    };
    Plane plane;
    Origin origin = kStockOrigin;
    std::vector<std::vector<Corner>> loops;
};

/// Returns the outlines of fragments, for Stitcher::add_part().
Outlines outlines_of(const std::vector<Fragment>& fragments);

/// Joins outlines that together are the whole surface of a solid. Pieces of one plane and one
/// origin are merged. All faces at an edge share every breakpoint, so there are no T-junctions. If
/// four or more faces meet in an edge, faces are paired around the material, and each surface has
/// separate vertices.
class Stitcher {
public:
    /// `threads`: 0 means one per hardware thread. The result does not depend on the number.
    Stitcher(const Lattice& lattice, std::size_t threads);
    ~Stitcher();

    /// Adds a part. Cost: expected O(pieces).
    void add_part(const Outlines& part);
    /// Adds edges of the outside along the border of the input. Ends of these edges divide
    /// coincident edges of the input.
    void add_outside(const Outlines& border);
    /// Returns the boundary; call after the last part. The result depends neither on the order of
    /// the pieces nor on the division of faces into pieces.
    /// Throws: std::logic_error if the pieces are not the whole surface, an error of the caller.
    /// Cost: expected O(n log n), mostly O(n); each hole is tested against all outlines of the same
    /// plane and origin.
    Boundary finish();
    /// The same for a part of a surface, which stays open where the outside continues and is
    /// divided there at the same points. Throws: std::logic_error at an edge without continuation.
    Boundary finish_open();
    /// Returns the edges of the input between points in one of `walls`, for add_outside() of the
    /// adjacent part.
    Outlines finish_border(const Walls& walls);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::cda
