// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about a cut, from the plan.
#include "ncsim/report/cutting_facts.h"

namespace ncsim::report {

CuttingFacts cutting_facts(const simulation::Plan& plan) {
    CuttingFacts facts;
    facts.model = plan.model;
    facts.resolution = plan.resolution;
    facts.has_rays_along_z_alone = plan.rays == simulation::RayDirections::AlongZ;
    facts.is_model_chosen = plan.is_model_chosen;
    facts.tolerance = plan.tolerance;
    facts.tool_tolerance = plan.tool_tolerance;
    facts.join_tolerance = plan.join_tolerance;
    facts.is_draft_exact = plan.is_draft_exact;
    facts.at_line = plan.at_line;
    return facts;
}

}  // namespace ncsim::report
