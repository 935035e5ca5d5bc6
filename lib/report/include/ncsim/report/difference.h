// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of two programs, as text and as JSON.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/difference.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::report {

using simulation::Difference;
using simulation::OneSidedMaterial;
using simulation::ProcessDifference;

/// Returns the difference as text.
std::string text_of(const Difference& difference, LengthUnit unit = LengthUnit::Millimetre);
/// Writes the difference as JSON; a list under "set_ups" if there are several. Lengths are in mm,
/// volumes in mm³.
/// Requires: at least one difference.
void write_differences(std::ostream& out, const std::vector<Difference>& differences);

}  // namespace ncsim::report
