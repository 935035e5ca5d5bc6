// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a solid of true surfaces: the polyhedron says which of them meet where, the program
// what they are.
#pragma once

#include "ncsim/brep/recognise.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Of the boundary of `simulation`, which must have kept it and its cuts. Facets are joined within
/// `tolerance_mm` first, as by simplify(). The program is interpreted once more, for the motions
/// that left a trace.
brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm);

}  // namespace ncsim::simulation
