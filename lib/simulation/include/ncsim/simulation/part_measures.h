// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part: bores, threads, countersinks, bosses, chamfers, corners, floors, distances of
// walls.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/measures.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Returns the measures of `solid` without the name of the program. `boundary` is the polyhedron of
/// the same part. Threads are those of the program of `plan`.
MeasureSheet measures_of(const Plan& plan, const Survey& survey, const Solid& solid,
                         const cda::Boundary& boundary);

}  // namespace ncsim::simulation
