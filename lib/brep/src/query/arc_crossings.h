// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs of a plane that are nearly tangent in a common corner and cross near the corner. mm, frame
// W.
#pragma once

#include "ncsim/brep/part.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::brep {

/// Returns two edges of the plane `face`, arcs or an arc and a line, that have a common corner and
/// meet again near this corner. The program meant both edges to be tangent in the corner, but
/// rounding prevents the tangency, and CAD readers report crossed loops. The test is exact except
/// for rounding; chords of the arcs would not show the crossing.
/// Cost: linear in the number of edges, if corners have few edges.
std::optional<std::array<std::uint32_t, 2>> arcs_crossing_near_corner(const Part& part,
                                                                      const Face& face);

}  // namespace ncsim::brep
