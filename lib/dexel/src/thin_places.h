// SPDX-License-Identifier: GPL-3.0-or-later
//
// What rays tell about their own limits: how much surface they met, and where material and gaps are
// thinner than the grid.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"

#include "rays.h"

namespace ncsim::dexel {

/// Adds what is thinner along these rays than the grid is there. What holds no corner of the grid
/// is missing in the surface.
void look_for_thin(const Rays& rays, const Grid& grid, const cda::Lattice& lattice,
                   cda::Aliasing& found);

/// Units³ by which the volume may be off, as far as the rays themselves can tell: between two
/// neighbours, whatever the planes at their ends do not explain is a wall, and is anywhere. What is
/// between all rays is not in it.
double doubtful_volume(const Rays& rays, const Grid& grid);

}  // namespace ncsim::dexel
