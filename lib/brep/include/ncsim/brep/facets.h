// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets of a boundary with the motions that cut each face.
#pragma once

#include "ncsim/cda/boundary.h"

#include <vector>

namespace ncsim::brep {

/// Boundary with the origins of each face: the motions that cut the face.
struct Facets {
    cda::Boundary boundary;
    std::vector<std::vector<cda::Origin>> origins;
};

}  // namespace ncsim::brep
