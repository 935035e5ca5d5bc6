// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every block removed and took, as a table.
#pragma once

#include "ncsim/report/entry.h"

#include <iosfwd>

namespace ncsim::report {

/// The ledger: one line for each execution of a block, after a line of names.
void write_ledger_csv(std::ostream& out, const Entries& all);

}  // namespace ncsim::report
