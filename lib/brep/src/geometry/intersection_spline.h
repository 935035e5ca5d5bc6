// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection curves that have no name (line, circle, ellipse), as splines.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface_forms.h"

#include <optional>
#include <vector>

namespace ncsim::brep {

/// Returns a spline along the intersection of two forms. `points` outlines the path: the first and
/// the last point are the ends, on both forms; points between are near the path.
/// Returns: a spline within 1e-5 mm of both forms, tested at four places between adjacent knots; no
/// value if the forms are tangent inside the path or the path is lost.
std::optional<Spline> intersection_spline(const Form& a, const Form& b,
                                          const std::vector<Vec3>& points);

}  // namespace ncsim::brep
