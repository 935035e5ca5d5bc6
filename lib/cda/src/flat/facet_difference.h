// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remainder f \ Down(f) of a facet: the facet minus masks, as polygons with holes. Thesis 8.2.
#pragma once

#include "ncsim/cda/polygon.h"

#include "surface/stitch.h"

#include <span>
#include <vector>

namespace ncsim::cda {

/// Returns `facet` minus `masks`, one fragment per connected part. The masks lie in the plane of
/// the facet, in either orientation. Uses CGAL's Polygon_set_2 on exact rationals: the masks are
/// joined as a range, then subtracted once.
std::vector<Fragment> facet_difference(const ConvexPolygon& facet,
                                       std::span<const ConvexPolygon> masks, Origin origin);

}  // namespace ncsim::cda
