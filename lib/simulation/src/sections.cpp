// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections of true surfaces, compared with sections of facets.
#include "ncsim/simulation/sections.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

// Returns the largest distance between true surfaces and facets, mm.
double error_of(const Plan& plan, const Simulation& simulation, const Solid& solid) {
    double polygons = std::max(plan.tool_tolerance, solid.tool_tolerance_mm);
    for (const auto& [tool, cutter] : simulation.cutters)
        polygons = std::max(polygons, cutter.error_mm);
    constexpr double kRounding = 2e-3;
    return 1.5 * (polygons + plan.tolerance + plan.join_tolerance) + kRounding +
           solid.recognised.mitred_mm + solid.recognised.part.facet_miss_mm;
}

}  // namespace

SectionView make_section_view(const Plan& plan, const Simulation& simulation, const Solid& solid,
                              const brep::SectionPlane& plane) {
    const cda::Boundary& boundary = *simulation.boundary;
    std::vector<std::vector<cda::Origin>> origins;
    for (const cda::BoundaryFace& face : boundary.faces)
        origins.push_back({face.origin});
    auto facets = brep::section_of(brep::faceted(boundary, origins), plane);
    if (!facets) throw std::logic_error("a polyhedron has no section");
    auto section = brep::section_of(solid.recognised.part, plane);
    const auto agrees = [&] {
        const double slack = std::max(section->area_per_mm, facets->area_per_mm);
        return std::abs(section->area_mm2 - facets->area_mm2) <=
               slack * error_of(plan, simulation, solid);
    };
    if (section && agrees()) return {std::move(*section), false};
    return {std::move(*facets), true};
}

}  // namespace ncsim::simulation
