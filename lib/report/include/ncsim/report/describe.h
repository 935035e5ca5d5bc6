// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptions of boxes, stock and volumes.
#pragma once

#include "ncsim/simulation/describe.h"

#include <string>

namespace ncsim::report {

using simulation::describe;

/// Returns "1.250 cm3".
std::string volume_text(double mm3);

}  // namespace ncsim::report
