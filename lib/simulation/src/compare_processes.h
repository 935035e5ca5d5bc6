// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/report/difference.h"
#include "ncsim/simulation/compare_parts.h"

namespace ncsim::simulation {

/// Compares feed, spindle, coolant and tool of the feed moves, and dwells, in their order. Moves in
/// a row under one condition count once, so a move in two halves is no difference.
/// Cost: one interpretation of each program.
report::ProcessDifference compare_processes(const Surveyed& old_side, const Surveyed& new_side);

}  // namespace ncsim::simulation
