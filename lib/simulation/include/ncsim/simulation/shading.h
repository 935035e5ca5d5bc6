// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shading of the part with the surfaces that the program's motions left.
#pragma once

#include "ncsim/brep/part_shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Returns the shading of `boundary`, which has the origins of `simulation`: the part's surface, or
/// a piece of the surface. The facets may have been joined within `tolerance_mm`, as by simplify().
/// Empty if the part was not cut exactly, or if the simulation did not keep the cuts.
/// Cost: a pass over the motions of the program.
brep::Shading shading_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                         const cda::Boundary& boundary, double tolerance_mm = 0.0);

}  // namespace ncsim::simulation
