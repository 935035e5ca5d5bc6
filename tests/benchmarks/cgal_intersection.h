// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of halfspaces by CGAL (halfspace_intersection_3: an inner point by its solver of
// quadratic programs, the dual, its convex hull, and back).
#pragma once

#include "ncsim/cda/plane.h"

#include <cstddef>
#include <vector>

namespace ncsim::bench {

/// Of the intersection: nothing has no corners. Units of the lattice.
struct CgalBody {
    double volume = 0.0;
    std::size_t corners = 0, facets = 0;
};

/// With exact numbers, or with exact decisions about points that are doubles. Throws what CGAL
/// throws.
CgalBody cgal_intersection_exact(const std::vector<cda::Plane>& planes);
CgalBody cgal_intersection_in_doubles(const std::vector<cda::Plane>& planes);

}  // namespace ncsim::bench
