// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces as splines. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"

#include <vector>

namespace ncsim::brep {

/// A B-spline surface: rows of control points, one for each control point around, of as many
/// as there are along. Each knot is different: the first and the last count `degree` + 1 times, the
/// others half as often. The normal is that of around with along: outwards, of the form.
struct Patch {
    std::vector<std::vector<Vec3>> net;
    std::vector<double> around, along;
    int degree = 3;  ///< 3 or 5, both ways.
};

}  // namespace ncsim::brep
