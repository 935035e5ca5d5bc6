// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quickhull in doubles: one function that hides the reentrant C interface of qhull.
// Source: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// The facets of a hull, coplanar facets merged: for each facet the corners (indices of points),
/// counter-clockwise seen from outside.
struct HullFacets {
    std::vector<std::vector<std::uint32_t>> loops;
};

/// Returns the hull; empty if the points are flat within the rounding of qhull.
std::optional<HullFacets> quickhull(std::span<const Vec3> points);

}  // namespace ncsim::cda
