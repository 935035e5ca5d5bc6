// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as stock of the next run.
#pragma once

#include "ncsim/cda/shape.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <string>
#include <vector>

namespace ncsim::simulation {

/// Returns the part after `simulation`, with the surfaces of the faces for read_stock_history(),
/// and with the assumptions of the run. Moves the removed cells out of `simulation`.
/// Requires: `simulation` kept the cuts and the removed cells.
/// Cost: the cost of the boundary, and a pass over the motions of the program.
cda::Shape take_left_shape(const Plan& plan, const Survey& survey, Simulation& simulation,
                           const std::vector<std::string>& assumed);

}  // namespace ncsim::simulation
