// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/plan.h"

#include "ncsim/cda/models.h"

#include <stdexcept>

namespace ncsim::simulation {

void require_verifying(const Plan& plan) {
    const cda::ModelInfo* model = cda::find_model(plan.model);
    if (model && model->verifies) return;
    throw std::invalid_argument(
        "programs are not verified with the model " + plan.model + ", but with " +
        cda::model_names([](const cda::ModelInfo& known) { return known.verifies; }));
}

report::CuttingFacts cutting_facts(const Plan& plan) {
    return {plan.model, plan.tolerance, plan.tool_tolerance, plan.join_tolerance, plan.at_line};
}

}  // namespace ncsim::simulation
