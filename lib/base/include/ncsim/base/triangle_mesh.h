// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes.
#pragma once

#include "ncsim/base/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim {

/// A triangle mesh, mm, workpiece frame.
struct TriangleMesh {
    std::vector<Vec3> vertices;
    /// Indices into `vertices`, counter-clockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Index of the face of the original surface that each triangle is part of.
    std::vector<std::uint32_t> face;
};

}  // namespace ncsim
