// SPDX-License-Identifier: GPL-3.0-or-later
//
// Horizontal sections of tools: nearly regular polygons with integer corners. The polygons of a
// family have parallel sides. So a strip between any two of them, at any heights and scales, has
// exactly planar trapezoids where both polygons have a side, and triangles elsewhere.
#pragma once

#include "ncsim/toolpath/side.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::toolpath {

/// A nearly regular polygon around the origin, in lattice units.
struct RingPolygon {
    int sides = 0;
    std::vector<std::pair<std::int64_t, std::int64_t>> corners;  ///< counter-clockwise
    double inner = 0.0;  ///< Radius of a circle about the origin within the polygon.
    double outer = 0.0;  ///< Radius of a circle about the origin around the polygon.
};

/// Returns the cosines that ring_polygon() needs. They do not depend on the radius. Requires:
/// `sides` is a multiple of 4.
std::vector<double> corner_cosines(int sides);

/// Returns a polygon around (inscribed: in) the circle of integer radius `b`. Four sides have the
/// normals ±x and ±y; circumscribed, these sides lie exactly at `b`.
RingPolygon ring_polygon(std::int64_t b, const std::vector<double>& cosines, Side side);

/// Returns `finest` and the polygons made of every m-th side of `finest`, for all m that leave a
/// multiple of four sides; the sides keep their lengths. The polygons are symmetric under rotation
/// by 90 degrees and under reflection at the axes and diagonals. Returns only `finest` if it is not
/// strictly convex, because its sides are a few units long.
std::vector<RingPolygon> add_coarser(RingPolygon finest);

/// Returns the number of facets of a strip between two rings: one per direction in which a ring has
/// a side.
int facets_between(int sides, int other_sides);

}  // namespace ncsim::toolpath
