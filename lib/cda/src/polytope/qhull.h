// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull (Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996) as this
// library uses it: the reentrant C interface of qhull behind one function.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// The facets of a hull, coplanar ones merged: for each its corners (indices into the points),
/// counter-clockwise seen from outside.
struct HullFacets {
    std::vector<std::vector<std::uint32_t>> loops;
};

/// Nothing where the points are flat within qhull's own rounding.
std::optional<HullFacets> quickhull(std::span<const Vec3> points);

}  // namespace ncsim::cda
