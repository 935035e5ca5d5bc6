// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs of a plane that run out together in a corner and cross near it. mm, frame W.
#pragma once

#include "ncsim/brep/part.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::brep {

/// Returns two edges of the plane `face`, arcs or an arc and a line, that have a corner in common
/// and meet again: arcs that are to be tangent there but miss each other by rounding. Readers
/// find such loops crossed. Exact but for the rounding of numbers: chords do not see it.
/// Cost: linear in the number of edges, if corners have few of them.
std::optional<std::array<std::uint32_t, 2>> arcs_that_cross_beside_corner(const Part& part,
                                                                          const Face& face);

}  // namespace ncsim::brep
