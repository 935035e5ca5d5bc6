// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that the motions of a program can leave on the part.
#pragma once

#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <functional>

namespace ncsim::simulation {

using SourceSink = std::function<void(cda::Origin, brep::SweptSurfaces)>;

/// Passes on the source of the stock, and the sources of the motions that `boundary` names, in
/// their order. Facets were joined within `tolerance_mm`. Requires: `simulation` kept its cuts.
/// Cost: one pass over the motions of the program.
void for_each_source(const Plan& plan, const Survey& survey, const Simulation& simulation,
                     const cda::Boundary& boundary, double tolerance_mm, const SourceSink& sink);

}  // namespace ncsim::simulation
