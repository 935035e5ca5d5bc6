// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/plan.h"

namespace ncsim::simulation {

report::CuttingFacts cutting_facts(const Plan& plan) {
    return {plan.model, plan.tolerance, plan.tool_tolerance, plan.join_tolerance, plan.at_line};
}

}  // namespace ncsim::simulation
