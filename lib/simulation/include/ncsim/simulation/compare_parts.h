// SPDX-License-Identifier: GPL-3.0-or-later
//
// Do two programs make the same part?
#pragma once

#include "ncsim/report/difference.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// A plan and what was seen of its program.
struct Surveyed {
    Plan plan;
    Survey survey;
};

/// Which material only one of the parts has, and which lines of the other program took it away.
/// Both must be ready, have the same stock and models that verify: throws std::invalid_argument if
/// one of them does not. Costs up to two simulations of each
/// program, of `a` alone if both make the same motions with the same tools. Names, tolerance and
/// what to conclude from them are left to the caller.
report::Difference compare_parts(const Surveyed& a, const Surveyed& b);

}  // namespace ncsim::simulation
