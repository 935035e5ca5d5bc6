// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline surfaces. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"

#include <vector>

namespace ncsim::brep {

/// B-spline surface. `net` has a row of control points for each control point around, each row with
/// as many points as there are along. Knots are distinct: the first and the last have multiplicity
/// `degree` + 1, inner knots half of this. The normal, d/d around x d/d along, points outwards from
/// the form.
struct Patch {
    std::vector<std::vector<Vec3>> net;
    std::vector<double> around, along;
    int degree = 3;  ///< 3 or 5, in both directions.
};

}  // namespace ncsim::brep
