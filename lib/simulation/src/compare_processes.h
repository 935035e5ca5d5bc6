// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the process values of two programs.
#pragma once

#include "ncsim/simulation/difference.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/review.h"
#include "ncsim/simulation/survey.h"

#include <map>

namespace ncsim::simulation {

/// Compares feed, spindle, coolant and tool of the feed moves, and dwells, in their order.
/// Successive moves under the same conditions count once, so a move in two halves is no difference.
/// Cost: one pass over the motions of each program.
ProcessDifference compare_processes(const Plan& old_plan, const Survey& old_survey,
                                    const Plan& new_plan, const Survey& new_survey);

/// Returns the feeds, speeds and coolant of the feed moves of each tool.
/// Cost: one pass over the motions of the program.
std::map<int, ToolProcess> processes_by_tool(const Plan& plan);

}  // namespace ncsim::simulation
