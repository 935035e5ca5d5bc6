// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of halfspaces by CGAL. halfspace_intersection_3 finds an inner point by quadratic
// programming and transforms back the convex hull of the dual.
#pragma once

#include "ncsim/cda/plane.h"

#include <cstddef>
#include <vector>

namespace ncsim::bench {

/// Intersection of halfspaces, in units of the lattice. An empty intersection has no corners.
struct CgalBody {
    double volume = 0.0;
    std::size_t corners = 0, facets = 0;
};

/// Returns the intersection with exact numbers. `cgal_intersection_in_doubles` decides exactly
/// about points that are doubles.
/// Throws: any exception of CGAL.
CgalBody cgal_intersection_exact(const std::vector<cda::Plane>& planes);
CgalBody cgal_intersection_in_doubles(const std::vector<cda::Plane>& planes);

}  // namespace ncsim::bench
