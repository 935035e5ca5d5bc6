// SPDX-License-Identifier: GPL-3.0-or-later
//
// The assumption sheet: values that the program specifies, values concluded from the program, and
// assumed values, so the basis of a result is visible.
#pragma once

#include "ncsim/report/cutting_facts.h"
#include "ncsim/simulation/facts.h"

#include <string>

namespace ncsim::report {

/// Returns the sheet as text, a line for each value, ending in a newline. `name` is the name of the
/// program.
std::string assumption_sheet(const std::string& name, const simulation::ProgramFacts& program,
                             const CuttingFacts& cutting);

}  // namespace ncsim::report
