// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections of the part, on true surfaces or on facets.
#pragma once

#include "ncsim/brep/section.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

namespace ncsim::simulation {

/// A section of the part.
struct SectionView {
    brep::Section section;
    /// True if the section is of the simulation's boundary, because true surfaces gave no closed
    /// outlines or outlines that deviate from the boundary. The origins are then those of the
    /// simulation, otherwise those of the solid.
    bool is_faceted = false;
};

/// Returns the section of `solid`, compared with the boundary of `simulation`, from which the solid
/// was made. Areas may differ by the errors of round tools and arcs. Throws: std::logic_error if
/// the boundary itself has no section.
SectionView make_section_view(const Plan& plan, const Simulation& simulation, const Solid& solid,
                              const brep::SectionPlane& plane);

}  // namespace ncsim::simulation
