// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ledger as two curves: removed volume and removal rate.
#pragma once

#include "ncsim/verify/ledger.h"

#include <string>

namespace ncsim::report {

/// Returns an SVG element: removed volume (mm³) over time, or over the path if times are unknown;
/// empty if no row removed material.
std::string removed_plot(const verify::Ledger& ledger);

/// Returns an SVG element: the rate in mm³ per minute over time, or in mm³ per mm of path.
std::string rate_plot(const verify::Ledger& ledger);

}  // namespace ncsim::report
