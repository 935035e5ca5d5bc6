// SPDX-License-Identifier: GPL-3.0-or-later
//
// Difference of a convex body and several convex bodies, as convex pieces. Exact and simple. The
// number of pieces grows with every cut, so the functions serve for single bodies (collision, the
// oracle of tests), not for whole parts.
#pragma once

#include "ncsim/cda/polytope.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Returns body \ (∪ taken) as full-dimensional pieces without common inner points.
std::vector<ConvexPolytope> difference(const ConvexPolytope& body,
                                       std::span<const ConvexPolytope* const> taken);

/// Returns the first such piece, depth first, for which `accept` is true.
std::optional<ConvexPolytope> first_of_difference(
    const ConvexPolytope& body, std::span<const ConvexPolytope* const> taken,
    const std::function<bool(const ConvexPolytope&)>& accept);

/// Returns a point strictly inside, in lattice units.
Vec3 inner_point(const ConvexPolytope& body);

}  // namespace ncsim::cda
