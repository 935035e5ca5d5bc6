// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of a part with the design, for pictures.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/render_options.h"
#include "ncsim/simulation/design_check.h"
#include "ncsim/simulation/design_facts.h"
#include "ncsim/simulation/simulate.h"

#include <vector>

namespace ncsim::simulation {

/// Number of classes of DesignView::areas_mm2.
inline constexpr std::size_t kDistanceClasses = 41;

/// Distances of a part from the design, and places of deviations.
struct DesignView {
    exporter::DesignDistances distances;
    DesignFacts facts;
    std::vector<DesignPlace> places;  ///< All gouges and excesses.
    /// Area of the surface by distance, mm²: kDistanceClasses equal classes from
    /// -distances.largest_mm to distances.largest_mm.
    std::vector<double> areas_mm2;
};

/// Compares `boundary`, the surface of the part of `simulation`, with `design`.
/// Requires: `simulation` kept the cuts.
/// Throws: std::runtime_error if no material of the part is left.
DesignView design_view(const Design& design, const Simulation& simulation,
                       const cda::Boundary& boundary);

}  // namespace ncsim::simulation
