// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the part is shaded: the program says which surfaces its facets approximate.
#pragma once

#include "ncsim/brep/shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Of `boundary`, which has the origins of `simulation`: its surface, or a piece of that; its
/// facets may have been joined within `tolerance_mm`, as by simplify(). Of a part that was not cut
/// exactly, or whose simulation did not keep its cuts, nothing is known. The program is interpreted
/// once more.
brep::Shading shading_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                         const cda::Boundary& boundary, double tolerance_mm = 0.0);

}  // namespace ncsim::simulation
