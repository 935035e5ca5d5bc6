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

struct Solid {
    brep::Recognised recognised;
    exporter::Provenance provenance;  ///< For its origins.
    /// Of the round tools, and of arcs, of the cut that said which surfaces meet where; those of
    /// the plan, unless it was another one.
    double tool_tolerance_mm = 0.0, arc_tolerance_mm = 0.0;
};

/// The same. Where more than one in a hundred faces are facets that were too large for what is
/// beside them, or any of a part of at most 20,000, the program is simulated once more with other
/// tolerances, mostly finer ones, up to `most_refinements` times (six are known), until there are
/// no such facets any more or those cuts have had 60,000 facets; what has the fewest counts.
Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, int most_refinements);

}  // namespace ncsim::simulation
