// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums the ledger by operation.
#include "ledger_operations.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace ncsim::report {

const simulation::CheckedOperation* operation_of(const Checked& checked, std::uint64_t motion) {
    const auto after = std::ranges::upper_bound(checked.operations, motion, {},
                                                &simulation::CheckedOperation::first_motion);
    return after == checked.operations.begin() ? nullptr : &*std::prev(after);
}

std::vector<LedgerOperation> ledger_operations(const Checked& checked) {
    std::vector<LedgerOperation> sums;
    std::map<std::pair<int, std::string>, std::size_t> sum_of;
    for (const verify::LedgerRow& row : checked.verdict.ledger.rows) {
        const simulation::CheckedOperation* const operation =
            operation_of(checked, row.first_motion);
        if (!operation) continue;
        const auto [found, is_new] =
            sum_of.emplace(std::pair(operation->tool, operation->name), sums.size());
        if (is_new) sums.push_back({*operation});
        LedgerOperation& sum = sums[found->second];
        sum.removed_mm3 += row.removed_mm3;
        if (row.kind != gcode::MoveKind::Feed) continue;
        sum.feed_mm += row.length_mm;
        if (!row.seconds) sum.seconds.reset();
        if (sum.seconds) *sum.seconds += *row.seconds;
    }
    std::erase_if(sums, [](const LedgerOperation& sum) { return sum.feed_mm <= 0.0; });
    const bool has_name = std::ranges::any_of(
        sums, [](const LedgerOperation& sum) { return !sum.operation.name.empty(); });
    if (sums.size() < 2 || !has_name) sums.clear();
    return sums;
}

}  // namespace ncsim::report
