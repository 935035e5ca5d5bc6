// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed mesh in floats, for formats that know nothing else.
#pragma once

#include "ncsim/cda/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

/// A corner as the file has it.
using FloatPoint = std::array<float, 3>;

struct FloatMesh {
    std::vector<FloatPoint> points;     ///< Those of triangles are all different.
    std::vector<std::uint32_t> vertex;  ///< For each point the vertex of the mesh that it was.
    /// Counter-clockwise seen from outside; in the order of their faces.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> face;  ///< As in cda::TriangleMesh.
};

/// The floats nearest to `p`, of zeros the one without a sign. Throws std::runtime_error if they
/// are beyond what floats are good for (2^100).
FloatPoint to_floats(cda::Vec3 p);

/// The corners of `mesh`, as seen from `origin` (mm), in floats, such that for a reader who knows
/// corners by their coordinates alone the triangles are a closed oriented 2-manifold: each directed
/// edge stands once, its reverse once, and around each corner there is one fan of triangles. No
/// triangle has a corner twice, or all on one line.
///
/// A coordinate is the float nearest to that of the mesh. Where that would make two corners one, or
/// triangles flat, which nothing that hangs together allows to be left out, a corner is moved on by
/// steps of 2^-23 of the largest coordinate (rounded down to a power of two): by one an axis, or by
/// the least number r of steps for which (2r + 1)³ exceeds the number of corners within r steps,
/// plus 2r + 1 for each triangle at the corner.
///
/// What has no extent in floats is not there: shells too small for them vanish, triangles become
/// edges, edges become points.
///
/// Requires a closed mesh; throws std::invalid_argument if it is not (std::logic_error: a bug).
/// The same for any number of threads, 0: as many as the machine has. Expected O(n log n).
FloatMesh round_to_floats(const cda::TriangleMesh& mesh, cda::Vec3 origin = {},
                          std::size_t threads = 1);

}  // namespace ncsim::exporter
