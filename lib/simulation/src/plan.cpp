// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/plan.h"

#include "ncsim/simulation/models.h"

#include <stdexcept>

namespace ncsim::simulation {

void require_verifying(const Plan& plan) {
    const ModelInfo* model = find_model(plan.model);
    if (model && model->verifies) return;
    throw std::invalid_argument("programs are not verified with the model " + plan.model +
                                ", but with " +
                                model_names([](const ModelInfo& known) { return known.verifies; }));
}

report::CuttingFacts cutting_facts(const Plan& plan) {
    return {plan.model,          plan.resolution,     plan.tolerance,
            plan.tool_tolerance, plan.join_tolerance, plan.at_line};
}

}  // namespace ncsim::simulation
