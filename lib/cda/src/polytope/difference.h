// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a convex body when others are taken from it, as convex pieces. Exact and
// simple; the number of pieces grows with every cut, so this is for questions about one body
// (collision, the oracle of tests), not for whole parts.
#pragma once

#include "ncsim/cda/polytope.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// body \ (∪ taken) as full-dimensional pieces without common inner points.
std::vector<ConvexPolytope> difference(const ConvexPolytope& body,
                                       std::span<const ConvexPolytope* const> taken);

/// The first of those pieces, depth first, for which `accept` answers true. Stops there.
std::optional<ConvexPolytope> first_of_difference(
    const ConvexPolytope& body, std::span<const ConvexPolytope* const> taken,
    const std::function<bool(const ConvexPolytope&)>& accept);

/// A point strictly inside, in lattice units.
Vec3 inner_point(const ConvexPolytope& body);

}  // namespace ncsim::cda
