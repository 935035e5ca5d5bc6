// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings next to the lines of a change, on GitHub.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/length_unit.h"

#include <string>

namespace ncsim::report {

/// Returns workflow commands that GitHub Actions shows next to the lines of a change, one a line.
/// Notes are included only if `notes`. Lengths are in `unit`.
std::string github_annotations(const Checked& checked, bool notes, LengthUnit unit);

}  // namespace ncsim::report
