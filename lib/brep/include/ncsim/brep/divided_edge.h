// SPDX-License-Identifier: GPL-3.0-or-later
//
// An edge in two pieces.
#pragma once

#include "ncsim/brep/parameter_curve.h"
#include "ncsim/brep/part.h"

#include <array>

namespace ncsim::brep {

/// Halves of an edge: from the start to `middle`, and on to the end.
struct EdgeHalves {
    Vec3 middle;
    Curve first, second;
};

/// Divides `edge` at `at` of its parameter, 0 to 1 exclusive. The halves together are the curve.
EdgeHalves divide_edge(const Part& part, const Edge& edge, double at);

/// Divides the curve of `edge` in the parameters of a surface where divide_edge() divides the edge.
std::array<ParameterCurve, 2> divide_curve(const ParameterCurve& curve, const Part& part,
                                           const Edge& edge, double at);

}  // namespace ncsim::brep
