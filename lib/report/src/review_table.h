// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the values of two programs: volume, time, path, and the conditions of each tool.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/review.h"

#include <string>

namespace ncsim::report {

/// Returns the table as HTML. Rows with different values have the class "differs".
std::string review_table(const simulation::Review& review, LengthUnit unit);

}  // namespace ncsim::report
