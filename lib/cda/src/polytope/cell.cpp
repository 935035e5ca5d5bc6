// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells from boxes.
#include "ncsim/cda/cell.h"

#include "ncsim/cda/lattice.h"

namespace ncsim::cda {

Cell box_cell(LatticePoint min, LatticePoint max, const Lattice& lattice, Origin origin) {
    Cell cell;
    cell.planes = {{1, 0, 0, max.x},   {-1, 0, 0, -min.x}, {0, 1, 0, max.y},
                   {0, -1, 0, -min.y}, {0, 0, 1, max.z},   {0, 0, -1, -min.z}};
    cell.bounds = {lattice.to_mm(min), lattice.to_mm(max)};
    cell.origin = origin;
    return cell;
}

}  // namespace ncsim::cda
