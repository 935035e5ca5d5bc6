// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a part: flat faces with holes, each naming the motion that cut it.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// A flat face. `loops[0]` is its outline, counter-clockwise seen from outside the material;
/// the others are holes, clockwise. Loops hold indices into Boundary::vertices.
struct BoundaryFace {
    Vec3 normal;          ///< Unit, pointing out of the material.
    double offset = 0.0;  ///< normal · x == offset on the face, up to rounding.
    Origin origin = kStockOrigin;
    std::uint32_t shell = 0;  ///< Connected surfaces are numbered from 0.
    std::vector<std::vector<std::uint32_t>> loops;
};

/// A set of closed oriented 2-manifolds: each directed edge of a loop stands once in each
/// direction. Surfaces that touch along an edge or in a vertex have vertices of their own there.
struct Boundary {
    std::vector<Vec3> vertices;
    std::vector<BoundaryFace> faces;
    std::uint32_t shells = 0;
};

/// Volume enclosed, in mm³, from the faces (divergence theorem); 0 for an empty boundary.
double volume(const Boundary& boundary);
/// Area of all faces in mm².
double area(const Boundary& boundary);
Box bounds(const Boundary& boundary);

}  // namespace ncsim::cda
