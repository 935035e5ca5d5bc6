// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every block removed and took, as a table.
#pragma once

#include "ncsim/report/checked.h"

#include <iosfwd>
#include <span>

namespace ncsim::report {

/// The ledger: one line for each execution of a block, after a line of names.
void write_ledger_csv(std::ostream& out, std::span<const Checked> all);

}  // namespace ncsim::report
