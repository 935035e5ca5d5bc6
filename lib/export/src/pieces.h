// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces for formats whose polygons have no holes, and whose readers cut concave ones wrongly:
// fans from a corner, or tessellators in floats, both of which lose volume.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Each face of a boundary as convex polygons: itself if it is one (but for rounding), else
/// triangles between its own vertices.
class Pieces {
public:
    /// `boundary` must outlive the pieces.
    explicit Pieces(const cda::Boundary& boundary);

    std::size_t count(std::uint32_t face) const;
    /// Vertices of piece `i` of the face, counter-clockwise seen from outside.
    std::span<const std::uint32_t> corners(std::uint32_t face, std::size_t i) const;

private:
    bool is_cut(std::uint32_t face) const { return is_cut_[face]; }

    const cda::Boundary& boundary_;
    std::vector<bool> is_cut_;           // by face
    cda::TriangleMesh mesh_;             // of the faces that are cut
    std::vector<std::uint32_t> first_;   // for each face, where in `sorted_` its triangles begin
    std::vector<std::uint32_t> sorted_;  // triangles of mesh_, by face
};

}  // namespace ncsim::exporter
