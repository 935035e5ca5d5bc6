// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums operations by tool and name.
#include "operation_rows.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace ncsim::report {

std::vector<OperationRow> operation_rows(const simulation::ProgramFacts& program,
                                         const std::vector<double>& removed,
                                         std::optional<int> tool) {
    std::vector<OperationRow> rows;
    std::map<std::pair<int, std::string>, std::size_t> row_of;
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const simulation::ProgramFacts::Operation& operation = program.operations[i];
        if (operation.distances.feed_mm <= 0.0 || (tool && operation.tool != *tool)) continue;
        const auto [found, is_new] =
            row_of.emplace(std::pair(operation.tool, operation.name), rows.size());
        if (is_new) {
            rows.push_back({operation, 0.0});
        } else {
            verify::Distances& sum = rows[found->second].operation.distances;
            sum = verify::total({{0, sum}, {1, operation.distances}});
        }
        if (i < removed.size()) rows[found->second].removed_mm3 += removed[i];
    }
    const bool has_name = std::ranges::any_of(
        rows, [](const OperationRow& row) { return !row.operation.name.empty(); });
    if (rows.size() < 2 || !has_name) rows.clear();
    return rows;
}

}  // namespace ncsim::report
