// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removed volume and time of every block, as a table.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/report/length_unit.h"

#include <iosfwd>

namespace ncsim::report {

/// Writes the ledger as CSV: a header, then a line for each execution of a block. `unit` is that of
/// the entries.
void write_ledger_csv(std::ostream& out, const Entries& all,
                      LengthUnit unit = LengthUnit::Millimetre);

}  // namespace ncsim::report
