// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces for formats whose polygons have no holes.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Each face of a boundary as polygons without holes: itself if it has none, else triangles between
/// its own vertices.
class Pieces {
public:
    /// `boundary` must outlive the pieces.
    explicit Pieces(const cda::Boundary& boundary);

    std::size_t count(std::uint32_t face) const;
    /// Vertices of piece `i` of the face, counter-clockwise seen from outside.
    std::span<const std::uint32_t> corners(std::uint32_t face, std::size_t i) const;

private:
    bool has_holes(std::uint32_t face) const { return boundary_.faces[face].loops.size() > 1; }

    const cda::Boundary& boundary_;
    cda::TriangleMesh mesh_;             // of the faces with holes
    std::vector<std::uint32_t> first_;   // for each face, where in `sorted_` its triangles begin
    std::vector<std::uint32_t> sorted_;  // triangles of mesh_, by face
};

}  // namespace ncsim::exporter
