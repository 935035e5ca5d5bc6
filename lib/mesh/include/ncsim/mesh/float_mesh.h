// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed mesh in floats, for formats without doubles.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::mesh {

/// Coordinates of a corner as in the file.
using FloatPoint = std::array<float, 3>;

/// A closed mesh in floats.
struct FloatMesh {
    std::vector<FloatPoint> points;     ///< Points used by triangles are all different.
    std::vector<std::uint32_t> vertex;  ///< For each point, the vertex of the original mesh.
    /// Counter-clockwise seen from outside; in the order of their faces.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> face;  ///< As in TriangleMesh.
};

/// Returns the floats nearest to `p`; never -0.
/// Throws: std::runtime_error if a coordinate is 2^100 or more.
FloatPoint to_floats(Vec3 p);

/// Rounds the corners of `mesh`, relative to `origin` (mm), to floats. A coordinate becomes the
/// nearest float. If rounding would make two corners equal or a triangle flat, and topology does
/// not allow their removal, a corner moves by steps of 2^-23 of the largest coordinate (rounded
/// down to a power of two). The number of steps per axis is 1, or the least r for which (2r + 1)³
/// exceeds the number of corners within r steps plus 2r + 1 for each triangle at the corner.
///
/// Parts without extent in floats are removed: shells that are too small vanish, thin triangles
/// become edges, and short edges become points. `threads`: 0 means as many as the machine has.
///
/// Requires: `mesh` is closed.
/// Guarantees: a reader that identifies corners by their coordinates sees a closed oriented
///     2-manifold: each directed edge occurs once, its reverse once, and around each corner there
///     is one fan of triangles. No triangle has a repeated corner or three collinear corners. The
///     result is the same for any number of threads.
/// Throws: std::invalid_argument if `mesh` is not closed; std::logic_error for a bug.
/// Cost: O(n log n) expected.
FloatMesh round_to_floats(const TriangleMesh& mesh, Vec3 origin = {}, std::size_t threads = 1);

}  // namespace ncsim::mesh
