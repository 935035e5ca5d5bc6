// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles, for formats that know nothing else.
#pragma once

#include "ncsim/cda/boundary.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

struct TriangleMesh {
    std::vector<Vec3> vertices;
    /// Counter-clockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// For each triangle the face of the Boundary it is part of.
    std::vector<std::uint32_t> face;
};

/// Cuts every face into triangles between its own vertices, so the mesh is closed if the boundary
/// is. Vertices are those of the boundary, in order, none moved; a few may follow: where edges of
/// one face cross by rounding, and in the middle of diagonals that would otherwise stand twice.
/// Expected O(n log n) per face. All `threads` work on it (0: as many as the machine has); the mesh
/// is the same for any number.
TriangleMesh triangulate(const Boundary& boundary, std::size_t threads = 1);

}  // namespace ncsim::cda
