// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names and texts of the result of a verification.
#pragma once

#include "ncsim/simulation/checked.h"
#include "ncsim/verify/finding.h"

#include <string>

namespace ncsim::report {

using simulation::Checked;

/// Returns "part.nc (O0101)": the path, and the program if the file has several.
std::string name_of(const Checked& checked);

/// Returns the relative path of the file with `place`.
std::string file_of(const Checked& checked, const verify::Place& place);

/// Returns message and quantity: "rapid move through material: removed 12.5 mm3".
std::string headline(const verify::Finding& finding);

}  // namespace ncsim::report
