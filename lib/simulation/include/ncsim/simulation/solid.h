// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a solid of true surfaces. The polyhedron determines which surfaces meet, and the
// program determines the surfaces.
#pragma once

#include "ncsim/brep/recognise.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <cstdint>

namespace ncsim::simulation {

/// Returns the solid of the boundary of `simulation`. Facets are first joined within
/// `tolerance_mm`, as by mesh::join_faces(). After `most_work` units of work (brep::recognise()),
/// all faces that fail become facets at once. Requires: `simulation` kept its boundary and its
/// cuts. Cost: one pass over the motions of the program, for the motions that left faces.
brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm, std::uint64_t most_work = brep::kUnlimitedWork);

/// Number of further cuts that refined_solid() knows.
inline constexpr int kKnownCuts = 6;

/// Limit of further cuts.
struct Refinement {
    int most_cuts = kKnownCuts;
    /// True: counted work is limited, too, so that a solid costs at most about three times the run
    /// without a solid, unless a finer cut of the tools is likely to recognise the facets.
    bool has_budget = true;
};

/// A solid with the accuracy of its cut.
struct Solid {
    brep::Recognised recognised;
    mesh::Provenance provenance;  ///< For the origins of the solid.
    /// Tolerances of round tools and of arcs in the cut that determined which surfaces meet; equal
    /// to the plan's unless a second cut was better.
    double tool_tolerance_mm = 0.0, arc_tolerance_mm = 0.0;
    int cuts = 0;            ///< Number of further cuts that were made.
    int cuts_not_tried = 0;  ///< Number of further cuts that the budget did not allow.
    /// True if corrections of the surfaces ended early because of the budget.
    bool has_ended_early = false;
};

/// Does the same, with further cuts. A further cut is made while `facets_demoted` facets are too
/// large for the adjacent faces: any such facet in a part of at most 20,000 facets, or more than a
/// hundredth of the faces. Parts of more than 60,000 facets (20,000 if a shell consists of facets
/// alone) are not cut again. The program is simulated again with other tolerances, mostly finer,
/// until `limit` is reached, or until these cuts have had 60,000 facets together. The solid with
/// the fewest unrecognised facets is returned.
///
/// Guarantees: the work is counted in hulls, facets and rounds of corrections, so the result
///     depends neither on the machine nor on the number of threads.
Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, const Refinement& limit);

}  // namespace ncsim::simulation
