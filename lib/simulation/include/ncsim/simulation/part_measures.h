// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part: bores, bosses, corners, floors, distances of walls.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/report/measure_sheet.h"
#include "ncsim/simulation/solid.h"

namespace ncsim::simulation {

/// Returns the measures of `solid` without the name of the program. `boundary` is the polyhedron of
/// the same part.
report::MeasureSheet measures_of(const Solid& solid, const cda::Boundary& boundary);

}  // namespace ncsim::simulation
