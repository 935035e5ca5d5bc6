// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of operations for people: what a tool does under the same name is one row.
#pragma once

#include "ncsim/simulation/facts.h"

#include <optional>
#include <vector>

namespace ncsim::report {

/// An operation that cuts, with the sums of its executions.
struct OperationRow {
    simulation::ProgramFacts::Operation operation;
    double removed_mm3 = 0.0;
};

/// Returns rows in the order of execution, of one tool or of all; none if there are fewer than two
/// or no row has a name. `removed` are the volumes (mm³) by operation; empty if they are not known.
std::vector<OperationRow> operation_rows(const simulation::ProgramFacts& program,
                                         const std::vector<double>& removed = {},
                                         std::optional<int> tool = std::nullopt);

}  // namespace ncsim::report
