// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/draft.h"

#include "ncsim/toolpath/tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::simulation {

void coarsen(Plan& plan, const Survey& survey, bool tolerance_told, bool tool_tolerance_told) {
    if (!plan.draft || !survey.is_ready()) return;
    constexpr double kCoarser = 4.0;  // than usual, at least
    constexpr double kOfBlock = 1.0 / 1200.0;
    constexpr double kToolOfBlock = 1.0 / 300.0;
    constexpr double kOfTool = 1.0 / 15.0;  // of a diameter
    constexpr double kMost = 1.0;           // mm
    const double size = norm(survey.stock->box.size());
    double thinnest = std::numeric_limits<double>::infinity();
    for (const auto& [number, used] : survey.tools)
        thinnest = std::min(thinnest, toolpath::cutting_diameter_of(used.tool));
    const auto hundredths = [](double mm) { return std::floor(100.0 * mm) / 100.0; };
    if (!tolerance_told) {
        const double most = std::min(kOfBlock * size, kMost);
        plan.tolerance = std::max(kCoarser * plan.tolerance, hundredths(most));
    }
    if (!tool_tolerance_told) {
        const double most = std::min({kToolOfBlock * size, kOfTool * thinnest, kMost});
        plan.tool_tolerance = std::max(kCoarser * plan.tool_tolerance, hundredths(most));
    }
    if (!plan.at_line) plan.join_tolerance = plan.tolerance;
}

}  // namespace ncsim::simulation
