// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part cut open: of its true surfaces, or of facets where these do not tell.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

namespace ncsim::simulation {

struct CutOpen {
    brep::Section section;
    /// Of the boundary of the simulation: true surfaces made no closed outlines, or others than
    /// the boundary has. Its origins are those of the simulation, else those of the solid.
    bool is_faceted = false;
};

/// Of `solid`, held against the boundary of `simulation`, which it is of: areas may differ by what
/// round tools and arcs are off. Throws std::logic_error if the boundary itself cannot be cut.
CutOpen cut_open(const Plan& plan, const Simulation& simulation, const Solid& solid,
                 const brep::SectionPlane& plane);

}  // namespace ncsim::simulation
