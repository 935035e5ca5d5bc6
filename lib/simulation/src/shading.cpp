// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shading from the surfaces that motions left.
#include "ncsim/simulation/shading.h"

#include "ncsim/simulation/models.h"

#include "sources.h"

namespace ncsim::simulation {

brep::Shading shading_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                         const cda::Boundary& boundary, double tolerance_mm) {
    if (simulation.cuts.empty() || !find_model(plan.model)->exact) return {};
    brep::ShadingMaker maker(boundary);
    for_each_source(
        plan, survey, simulation, boundary, tolerance_mm,
        [&](cda::Origin origin, const brep::SweptSurfaces& source) { maker.take(origin, source); });
    return maker.finish();
}

}  // namespace ncsim::simulation
