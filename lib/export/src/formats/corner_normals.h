// SPDX-License-Identifier: GPL-3.0-or-later
//
// With which normals a mesh is shaded whose facets are flat and whose surface is not.
#pragma once

#include "ncsim/brep/shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"

#include "render/palette.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

/// Normals of face corners: those of the surface, where it is known to be round. Elsewhere the
/// average of those of the faces around the vertex, weighted by area, that were cut by the same
/// tool and meet the face at less than the crease angle: curves are often many short lines. What is
/// known to be flat heeds nothing that is round; uncut stock is flat.
class CornerNormals {
public:
    /// All of them must outlive it.
    CornerNormals(const cda::Boundary& boundary, const Provenance& provenance,
                  const Palette& palette, const brep::Shading& shading);

    /// Unit. `vertex` is that of the boundary, or, for points inside a face, any other number;
    /// `point` is where it is.
    cda::Vec3 at(std::uint32_t face, std::uint32_t vertex, cda::Vec3 point) const;

private:
    cda::Vec3 area_vector(const cda::BoundaryFace& face) const;

    const cda::Boundary& boundary_;
    const brep::Shading& shading_;
    std::vector<std::size_t> maker_;    // of each face, by rank; 0: the stock
    std::vector<cda::Vec3> weighted_;   // of each face
    std::vector<std::uint32_t> first_;  // for each vertex, where in `faces_` its faces begin
    std::vector<std::uint32_t> faces_;
};

}  // namespace ncsim::exporter
