// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons of mesh files, and their division into triangles.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Reason why a mesh is refused.
struct Refused {
    std::string reason;
};

/// Faces of a mesh file.
struct Polygons {
    std::vector<Vec3> points;
    /// Point indices of each face, counter-clockwise seen from outside.
    std::vector<std::vector<std::uint32_t>> faces;
};

/// Returns three corners per triangle. Faces need not be convex; faces with fewer than three
/// corners, or without area, are left out. Throws: Refused if a point is too far out, or a face has
/// an invalid index.
std::vector<Vec3> corners_of(const Polygons& polygons);

}  // namespace ncsim::setup
