// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger on a page: curves, totals, operations.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/length_unit.h"

#include <string>

namespace ncsim::report {

/// Returns a section of HTML, with lengths in `unit`.
std::string ledger_html(const Checked& checked, LengthUnit unit);

}  // namespace ncsim::report
