// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger by operation.
#pragma once

#include "ncsim/report/checked.h"

#include <cstdint>
#include <vector>

namespace ncsim::report {

/// Sums over the rows of the ledger with the same tool and the same name of operation.
struct LedgerOperation {
    simulation::CheckedOperation operation;
    double feed_mm = 0.0;  ///< Path of blocks with feed moves.
    double removed_mm3 = 0.0;
    std::optional<double> seconds = 0.0;  ///< Time of these blocks; empty if a time is unknown.
};

/// Returns the operation of a motion, or null. Cost: O(log operations).
const simulation::CheckedOperation* operation_of(const Checked& checked, std::uint64_t motion);

/// Returns operations that cut, in the order of execution; none if there are fewer than two or none
/// has a name.
std::vector<LedgerOperation> ledger_operations(const Checked& checked);

}  // namespace ncsim::report
