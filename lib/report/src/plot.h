// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger as two curves: removed volume and removal rate.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/verify/ledger.h"

#include <string>

namespace ncsim::report {

/// Returns an SVG element: removed volume over time, or over the path if times are unknown; empty
/// if no row removed material. Lengths and volumes are in `unit`.
std::string removed_plot(const verify::Ledger& ledger, LengthUnit unit);

/// Returns an SVG element: the rate per minute over time, or per length of path.
std::string rate_plot(const verify::Ledger& ledger, LengthUnit unit);

}  // namespace ncsim::report
