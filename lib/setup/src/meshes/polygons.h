// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons as files tell them, as triangles.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Why a mesh is not taken.
struct Refused {
    std::string reason;
};

struct Polygons {
    std::vector<cda::Vec3> points;
    /// Each counter-clockwise seen from outside, by numbers of points.
    std::vector<std::vector<std::uint32_t>> faces;
};

/// Three corners for each triangle. Faces need not be convex; those of fewer than three corners, or
/// without area, are left out. Throws Refused if a point is no place, or a face names none.
std::vector<cda::Vec3> corners_of(const Polygons& polygons);

}  // namespace ncsim::setup
