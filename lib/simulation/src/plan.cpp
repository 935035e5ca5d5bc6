// SPDX-License-Identifier: GPL-3.0-or-later
//
// Requirements and facts of a plan.
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
    report::CuttingFacts facts;
    facts.model = plan.model;
    facts.resolution = plan.resolution;
    facts.has_rays_along_z_alone = plan.rays == RayDirections::AlongZ;
    facts.is_model_chosen = plan.is_model_chosen;
    facts.tolerance = plan.tolerance;
    facts.tool_tolerance = plan.tool_tolerance;
    facts.join_tolerance = plan.join_tolerance;
    facts.is_draft_exact = plan.is_draft_exact;
    facts.at_line = plan.at_line;
    return facts;
}

}  // namespace ncsim::simulation
