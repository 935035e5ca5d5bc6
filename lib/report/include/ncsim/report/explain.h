// SPDX-License-Identifier: GPL-3.0-or-later
//
// Explains a block of a program.
#pragma once

#include "ncsim/report/explanation.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include <cstdint>
#include <string>

namespace ncsim::report {

/// Explains the block at `line` (from 1) of `file`: name of a called file, or last part of the
/// name; empty for the main program.
/// Requires: `survey` is survey(plan).
/// Throws: std::runtime_error if no called file has this name, or if the file has fewer lines.
/// Cost: interprets the program once. With the removed volume, simulates the program up to the
/// block, or to the end if the block is executed several times.
Explanation explain(const simulation::Plan& plan, const simulation::Survey& survey,
                    std::uint32_t line, const std::string& file = {}, bool with_volume = true);

}  // namespace ncsim::report
