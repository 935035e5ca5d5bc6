// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger as two curves: what was removed so far, and how fast.
#pragma once

#include "ncsim/verify/ledger.h"

#include <string>

namespace ncsim::report {

/// An SVG element: removed volume (mm³) over time, or over the path where times are not known.
/// Empty without rows that removed anything.
std::string removed_plot(const verify::Ledger& ledger);

/// The rate: mm³ per minute over time, or mm³ per mm of path.
std::string rate_plot(const verify::Ledger& ledger);

}  // namespace ncsim::report
