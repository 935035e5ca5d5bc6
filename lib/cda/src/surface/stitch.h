// SPDX-License-Identifier: GPL-3.0-or-later
//
// From outlines of pieces of facets to a watertight boundary.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include "surface/outlines.h"

#include <memory>
#include <vector>

namespace ncsim::cda {

/// A connected piece of the surface: in an oriented plane that has the material below it, with
/// exact corners. Loops have the piece on their left, seen from outside the material. Pieces in the
/// same plane have no inner points in common.
struct Fragment {
    struct Corner {
        ExactPoint point;  ///< On the planes of both edges that meet here.
        Plane edge;  ///< A plane, not parallel to the fragment's, with the edge to the next corner
                     ///< in it.
    };
    Plane plane;
    Origin origin = kStockOrigin;
    std::vector<std::vector<Corner>> loops;
};

Outlines outlines_of(const std::vector<Fragment>& fragments);

/// Joins outlines that together are the whole surface of a solid. Pieces of one plane and one
/// origin grow together; every breakpoint of an edge is shared by all faces at it, so there are no
/// T-junctions; where four or more faces meet in an edge they are paired around the material, and
/// each surface gets vertices of its own.
class Stitcher {
public:
    /// 0 threads: as many as the machine has. The result does not depend on how many.
    Stitcher(const Lattice& lattice, std::size_t threads);
    ~Stitcher();

    /// Expected O(pieces).
    void take(const Outlines& part);
    /// Edges of what lies beyond, of its border with what was taken: where they end, edges that lie
    /// upon them are cut.
    void take_outside(const Outlines& border);
    /// After all parts. The result does not depend on the order of the pieces nor on how faces were
    /// cut into them. Expected O(n log n), most of it O(n); a hole is looked for in all outlines of
    /// its plane and origin. Throws std::logic_error if they are not the whole surface: a fault of
    /// the caller's.
    Boundary finish();
    /// The same of what is a part of the surface of a solid; open where it goes on outside, and
    /// cut there as that is. Throws std::logic_error where nothing is beyond.
    Boundary finish_open();
    /// Of the same: its edges between points in one of `walls`, for who has to do with what is
    /// beyond.
    Outlines finish_border(const Walls& walls);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ncsim::cda
