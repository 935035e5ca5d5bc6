// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection curves as splines: curves that have no name (line, circle, ellipse), and arcs whose
// corners miss their circle.
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

/// Returns the arc of `circle` from `from` to `to`, counter-clockwise about the axis, as a spline
/// that ends in both points, which may miss the circle by a distance d. The first and the last
/// piece go from the point to the circle and have the direction of the circle at both ends. Pieces
/// turn by 15° at most, and inner pieces are within 1e-9 mm of the circle, unless pieces would be
/// shorter than 100 d: shorter pieces leave the direction of the circle on their way.
///
/// The spline deviates most at an end. CAD readers measure an edge at both ends and at a few places
/// between, and reject an edge that deviates more elsewhere. Some Boolean operations of CAD readers
/// fail where edges are off the adjacent surfaces along their length.
Spline arc_spline(const Circle& circle, Vec3 from, Vec3 to);

}  // namespace ncsim::brep
