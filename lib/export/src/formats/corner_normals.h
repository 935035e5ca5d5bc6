// SPDX-License-Identifier: GPL-3.0-or-later
//
// Normals for shading a mesh with flat facets whose true surface is curved.
#pragma once

#include "ncsim/brep/part_shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"

#include "render/palette.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

/// Normals of face corners. If the surface of a face is known to be round, the normal is that of
/// the surface. Otherwise the normal is the average over the faces around the vertex, weighted by
/// area, that were cut by the same tool and meet the face at less than the crease angle, because
/// curves are often many short lines. A face known to be flat ignores adjacent round faces; uncut
/// stock is flat.
class CornerNormals {
public:
    /// Requires: all arguments outlive the object.
    CornerNormals(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                  const Palette& palette, const brep::Shading& shading);

    /// Returns the unit normal of `face` at `point`. `vertex` is the vertex of the boundary at
    /// `point`, or any larger number for a point inside the face.
    Vec3 at(std::uint32_t face, std::uint32_t vertex, Vec3 point) const;

private:
    Vec3 area_vector(const cda::BoundaryFace& face) const;

    const cda::Boundary& boundary_;
    const brep::Shading& shading_;
    std::vector<std::size_t> maker_;    // rank of each face's tool; 0: the stock
    std::vector<Vec3> weighted_;        // area vector of each face
    std::vector<std::uint32_t> first_;  // for each vertex, start of the faces in `faces_`
    std::vector<std::uint32_t> faces_;
};

}  // namespace ncsim::exporter
