// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a solid of true surfaces. The polyhedron determines which surfaces meet, and the
// program determines the surfaces.
#pragma once

#include "ncsim/brep/recognise.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Returns the solid of the boundary of `simulation`. Facets are first joined within
/// `tolerance_mm`, as by simplify(). Requires: `simulation` kept its boundary and its cuts.
/// Cost: one pass over the motions of the program, for the motions that left faces.
brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm);

/// A solid with the accuracy of its cut.
struct Solid {
    brep::Recognised recognised;
    exporter::Provenance provenance;  ///< For the origins of the solid.
    /// Tolerances of round tools and of arcs in the cut that determined which surfaces meet; equal
    /// to the plan's unless a second cut was better.
    double tool_tolerance_mm = 0.0, arc_tolerance_mm = 0.0;
};

/// Does the same, with further cuts. A further cut is made while `facets_demoted` facets are too
/// large for the adjacent faces: any such facet in a part of at most 20,000 facets, or more than a
/// hundredth of the faces. Parts of more than 60,000 facets (20,000 if a shell consists of facets
/// alone) are not cut again. The program is simulated again with other tolerances, mostly finer, up
/// to `most_refinements` times (six are known), or until these cuts have had 60,000 facets
/// together. The solid with the fewest unrecognised facets is returned.
Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, int most_refinements);

}  // namespace ncsim::simulation
