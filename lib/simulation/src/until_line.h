// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number of motions up to a line of the program.
#pragma once

#include "ncsim/simulation/plan.h"

#include <cstdint>

namespace ncsim::simulation {

/// Returns the number of motions until `line` of the program was run for the first time. If the
/// line makes no motion, the nearest preceding line with a motion counts.
std::uint64_t motions_until(const Plan& plan, std::uint32_t line);

}  // namespace ncsim::simulation
