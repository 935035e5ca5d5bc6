// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rule path-accuracy: a path that was not followed within the tolerance was not verified.
#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

namespace ncsim::verify {

void judge_path_accuracy(const Setup& setup, const Move& move, FindingLog& log) {
    if (move.path_error_mm <= 0.0) return;
    Occurrence s{
        fmt::format("this move takes more steps than are made of one: its path is not followed "
                    "to {:.6g} mm",
                    setup.path_tolerance_mm)};
    s.quantity = Quantity{"missed by up to", move.path_error_mm, "mm"};
    s.box = move.path;
    log.add("path-accuracy", move, std::move(s));
}

}  // namespace ncsim::verify
