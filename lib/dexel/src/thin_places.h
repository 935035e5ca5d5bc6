// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits of resolution that rays can detect: walls of unknown position, and places where material
// or gaps are thinner than the grid.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"

#include "rays.h"

namespace ncsim::dexel {

/// Adds the places that are thinner along these rays than the grid. A place that contains no corner
/// of the grid is missing in the surface.
void find_thin_places(const Rays& rays, const Grid& grid, const cda::Lattice& lattice,
                      cda::Aliasing& found);

/// Returns the largest error of the volume in cubic units, as far as the rays can bound the error.
/// Between adjacent rays, a difference in length that the planes at the ends do not explain is a
/// wall of unknown position. Features between all rays are not included.
double doubtful_volume(const Rays& rays, const Grid& grid);

}  // namespace ncsim::dexel
