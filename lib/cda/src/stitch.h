// SPDX-License-Identifier: GPL-3.0-or-later
//
// From fragments of facets to a watertight boundary.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/predicates.h"

#include <vector>

namespace ncsim::cda {

/// A connected piece of the surface: in an oriented plane that has the material below it, with
/// exact corners. Loops have the piece on their left, seen from outside the material. Pieces in the
/// same plane have no inner points in common.
struct Fragment {
    struct Corner {
        ExactPoint point;
        Plane edge;  ///< A plane, not parallel to the fragment's, with the edge to the next corner
                     ///< in it.
    };
    Plane plane;
    Origin origin = kStockOrigin;
    std::vector<std::vector<Corner>> loops;
};

/// Joins fragments that together are the whole surface of a solid. Pieces of one plane and one
/// origin grow together; every breakpoint of an edge is shared by all faces at it, so there are no
/// T-junctions; where four or more faces meet in an edge they are paired around the material, and
/// each surface gets vertices of its own. The result does not depend on the order of the fragments
/// nor on how faces were cut into them. O(n log n).
Boundary stitch(const std::vector<Fragment>& fragments, const Lattice& lattice);

}  // namespace ncsim::cda
