// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part, as text and as JSON.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/measures.h"

#include <iosfwd>
#include <string>

namespace ncsim::report {

using simulation::CutBy;
using simulation::EarlierLine;
using simulation::MeasuredBore;
using simulation::MeasuredBoss;
using simulation::MeasuredChamfer;
using simulation::MeasuredCorner;
using simulation::MeasuredCountersink;
using simulation::MeasuredDistance;
using simulation::MeasuredFloor;
using simulation::MeasuredThread;
using simulation::MeasureSheet;

/// Returns the measures as text, with lengths to a micrometre and at most 40 rows of a kind.
std::string text_of(const MeasureSheet& sheet, LengthUnit unit = LengthUnit::Millimetre);

/// Writes all measures as JSON, UTF-8, to a millionth of a mm. Keys are only added.
void write_measures(std::ostream& out, const MeasureSheet& sheet);

}  // namespace ncsim::report
