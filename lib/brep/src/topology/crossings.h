// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in which edges pass through a plane.
#pragma once

#include "ncsim/brep/part.h"

#include "geometry/plane_cut.h"

#include <vector>

namespace ncsim::brep {

/// Passage of an edge through a plane.
struct Crossing {
    Vec3 at;              ///< In the plane, or as near to the plane as the edge comes.
    Vec3 above;           ///< Point of the edge that is `lift` above the plane.
    bool goes_up = true;  ///< True if the edge rises there, from its start to its end.
};

/// Returns the passages of the edge between heights of at most `lift` mm above the plane and
/// greater heights, in order along the edge. The vertices alone decide whether the ends are above,
/// so that adjacent edges agree.
std::vector<Crossing> crossings_of(const Part& part, const Edge& edge, const CutPlane& plane,
                                   double lift);

}  // namespace ncsim::brep
