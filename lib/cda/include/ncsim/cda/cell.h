// SPDX-License-Identifier: GPL-3.0-or-later
//
// A convex body as the kernel takes it in: halfspaces, and who made it.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/vec.h"

#include <vector>

namespace ncsim::cda {

/// The intersection of halfspaces; bounded. Redundant planes are allowed. `bounds` (mm)
/// encloses it, not necessarily tightly; it is used to reject, never to decide.
struct Cell {
    std::vector<Plane> planes;
    Box bounds;
    Origin origin = kStockOrigin;
};

/// The box with the corners `min` and `max`, in lattice units.
Cell box_cell(LatticePoint min, LatticePoint max, const Lattice& lattice,
              Origin origin = kStockOrigin);

}  // namespace ncsim::cda
