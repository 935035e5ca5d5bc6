// SPDX-License-Identifier: GPL-3.0-or-later
//
// f \ Down(f): a facet less its masks, as polygons with holes. Thesis 8.2.
#pragma once

#include "ncsim/cda/polygon.h"

#include "surface/stitch.h"

#include <span>
#include <vector>

namespace ncsim::cda {

/// `facet` less `masks`, which lie in the same plane, whichever side of it is up for them. One
/// fragment for each connected part. By CGAL's Polygon_set_2 on exact rationals: the masks are
/// joined as a range, then subtracted once.
std::vector<Fragment> facet_difference(const ConvexPolygon& facet,
                                       std::span<const ConvexPolygon> masks, Origin origin);

}  // namespace ncsim::cda
