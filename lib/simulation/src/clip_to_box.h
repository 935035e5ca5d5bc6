// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of convex polygons in a box.
#pragma once

#include "ncsim/base/vec3.h"

#include <span>
#include <vector>

namespace ncsim::simulation {

/// Returns the part of a convex polygon that is in `box`; empty if there is none.
std::vector<Vec3> clip_to_box(std::vector<Vec3> polygon, const Box& box);

/// Returns the area of a convex polygon, mm².
double area_of_polygon(std::span<const Vec3> polygon);

}  // namespace ncsim::simulation
