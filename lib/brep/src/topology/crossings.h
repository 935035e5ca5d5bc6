// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where edges pass through a plane.
#pragma once

#include "ncsim/brep/part.h"

#include "geometry/plane_cut.h"

#include <vector>

namespace ncsim::brep {

struct Crossing {
    Vec3 at;              ///< In the plane, or as near to it as the edge comes.
    Vec3 above;           ///< Where it is `lift` above it.
    bool goes_up = true;  ///< From the start of the edge to its end.
};

/// Where the edge passes from what is no more than `lift` mm above the plane to what is more, or
/// back, in order along the edge. Whether its ends are above is a matter of the vertices alone, so
/// that edges agree.
std::vector<Crossing> crossings_of(const Part& part, const Edge& edge, const CutPlane& plane,
                                   double lift);

}  // namespace ncsim::brep
