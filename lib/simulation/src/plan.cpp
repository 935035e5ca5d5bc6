// SPDX-License-Identifier: GPL-3.0-or-later
//
// Requirements of a plan.
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

}  // namespace ncsim::simulation
