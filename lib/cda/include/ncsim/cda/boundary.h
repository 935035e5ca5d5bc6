// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a part: planar faces with holes, each with the motion that cut the face.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// A planar face. `loops[0]` is the outline, counter-clockwise seen from outside the material; the
/// remaining loops are holes, clockwise. Loops hold indices into Boundary::vertices.
struct BoundaryFace {
    Vec3 normal;          ///< Unit vector that points out of the material.
    double offset = 0.0;  ///< normal · x == offset on the face, up to rounding.
    Origin origin = kStockOrigin;
    std::uint32_t shell = 0;  ///< Number of the connected surface, from 0.
    std::vector<std::vector<std::uint32_t>> loops;
};

/// A set of closed oriented 2-manifolds. Guarantees: each directed edge of a loop has exactly one
/// partner in the opposite direction. Where two surfaces touch along an edge or at a vertex, each
/// surface has separate vertices.
struct Boundary {
    std::vector<Vec3> vertices;
    std::vector<BoundaryFace> faces;
    std::uint32_t shells = 0;
};

/// Returns the enclosed volume in mm³ by the divergence theorem; 0 for an empty boundary.
double volume(const Boundary& boundary);
/// Returns the area of all faces in mm².
double area(const Boundary& boundary);
/// Returns the smallest box around all vertices, mm.
Box bounds(const Boundary& boundary);

}  // namespace ncsim::cda
