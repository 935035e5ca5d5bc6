// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/simulation/plan.h"

#include <cstdint>

namespace ncsim::simulation {

/// Motions until `line` of the program has been run for the first time. If it makes none, the
/// nearest line before it that does counts.
std::uint64_t motions_until(const Plan& plan, std::uint32_t line);

}  // namespace ncsim::simulation
