// SPDX-License-Identifier: GPL-3.0-or-later
//
// The assumption sheet: what the program said, what was concluded, what had to be assumed. Nobody
// should have to guess what a result stands on.
#pragma once

#include "ncsim/report/facts.h"

#include <string>

namespace ncsim::report {

/// Text for people, a line for each thing; ends in a newline. `name` is the program's.
std::string assumption_sheet(const std::string& name, const ProgramFacts& program,
                             const CuttingFacts& cutting);

}  // namespace ncsim::report
