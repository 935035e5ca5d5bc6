// SPDX-License-Identifier: GPL-3.0-or-later
//
// The horizontal sections of tools: nearly regular polygons with integer corners. Those of one
// family have parallel sides, so that a strip between any two of them, at whatever heights and
// however enlarged, has exactly flat trapezoids where both have a side, and triangles elsewhere.
#pragma once

#include "ncsim/toolpath/side.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::toolpath {

struct RingPolygon {
    int sides = 0;
    std::vector<std::pair<std::int64_t, std::int64_t>> corners;  ///< counter-clockwise
    double inner = 0.0;  ///< Radius of a circle about the origin that lies within.
    double outer = 0.0;  ///< Of one that holds it.
};

/// The cosines that ring_polygon() needs, which are the same for all radii. `sides` is a multiple
/// of 4.
std::vector<double> corner_cosines(int sides);

/// Around (or in) the circle of integer radius b. Four sides have the normals ±x and ±y;
/// circumscribed, they lie exactly at b.
RingPolygon ring_polygon(std::int64_t b, const std::vector<double>& cosines, Side side);

/// The polygons made of every m-th side of `finest`, which is the first of them, for all m that
/// leave a multiple of four: each side as long as it is there. Turns by 90 degrees and the mirrors
/// of the axes and diagonals lead them to themselves. `finest` alone where it is not convex, since
/// its sides are a few units long.
std::vector<RingPolygon> with_coarser(RingPolygon finest);

/// The facets of a strip between two rings: one for every direction in which either has a side.
int facets_between(int sides, int other_sides);

}  // namespace ncsim::toolpath
