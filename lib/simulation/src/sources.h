// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which surfaces those can have left who cut a part.
#pragma once

#include "ncsim/brep/swept.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <functional>

namespace ncsim::simulation {

using SourceSink = std::function<void(cda::Origin, brep::Source)>;

/// Hands on the source of the stock, and those of the motions that `boundary` names, in their
/// order. Facets were joined within `tolerance_mm`. `simulation` must have kept its cuts. The
/// program is interpreted once more.
void for_each_source(const Plan& plan, const Survey& survey, const Simulation& simulation,
                     const cda::Boundary& boundary, double tolerance_mm, const SourceSink& sink);

}  // namespace ncsim::simulation
