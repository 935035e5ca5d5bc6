// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planes with which readers do not get along.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Planes, ascending, in which readers find a fault (crossed_planes()), or nothing at all: their
/// edges, which are straight, are all shorter than 3e-5 mm, or they are narrower than what one of
/// their corners is off the planes around it, or a hole than twice that. O(n log n) for n edges
/// that are spread evenly.
std::vector<std::uint32_t> degenerate_planes(const Part& part);

}  // namespace ncsim::brep
