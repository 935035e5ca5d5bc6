// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the process values of two programs.
#pragma once

#include "ncsim/report/difference.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Compares feed, spindle, coolant and tool of the feed moves, and dwells, in their order.
/// Successive moves under the same conditions count once, so a move in two halves is no difference.
/// Cost: one interpretation of each program.
report::ProcessDifference compare_processes(const Plan& old_plan, const Survey& old_survey,
                                            const Plan& new_plan, const Survey& new_survey);

}  // namespace ncsim::simulation
