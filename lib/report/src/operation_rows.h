// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of operations for tables: operations of a tool with the same name are a single row.
#pragma once

#include "ncsim/simulation/facts.h"

#include <optional>
#include <vector>

namespace ncsim::report {

/// Cutting operation, with the sums over all executions.
struct OperationRow {
    simulation::ProgramFacts::Operation operation;
    double removed_mm3 = 0.0;
};

/// Returns rows in the order of execution, of `tool` or of all tools; none if there are fewer than
/// two rows or no row has a name. `removed`: removed volume of each operation, mm³; empty if
/// unknown.
std::vector<OperationRow> operation_rows(const simulation::ProgramFacts& program,
                                         const std::vector<double>& removed = {},
                                         std::optional<int> tool = std::nullopt);

}  // namespace ncsim::report
