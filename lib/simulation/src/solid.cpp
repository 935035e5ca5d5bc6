// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognition of solids, with further cuts.
#include "ncsim/simulation/solid.h"

#include "ncsim/export/simplify.h"
#include "ncsim/simulation/models.h"

#include "sources.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm) {
    // Facets in one plane need not be on a common surface: the bottoms of all grooves of a ball end
    // mill are in one plane. So facets of different motions stay separate, as with different lines.
    exporter::Provenance apart;
    for (std::uint32_t i = 0; i < simulation.provenance.entries.size(); ++i)
        apart.entries.push_back({i, 0});
    const auto facets = [&](double tolerance, const exporter::Provenance* lines) {
        exporter::Simplified flat = exporter::simplify(*simulation.boundary, tolerance, lines);
        return brep::Facets{std::move(flat.boundary), std::move(flat.origins)};
    };
    std::map<cda::Origin, brep::SweptSurfaces> sources;
    for_each_source(plan, survey, simulation, *simulation.boundary, tolerance_mm,
                    [&](cda::Origin origin, brep::SweptSurfaces source) {
                        sources[origin] = std::move(source);
                    });
    brep::Recognised solid =
        brep::recognise(facets(tolerance_mm, &apart), sources,
                        [&](double times) { return facets(times * tolerance_mm, nullptr); });
    if (survey.stock->from && !simulation.history) {
        solid.stock_facets = brep::mark_tessellated(solid.part, cda::kStockOrigin);
        solid.facets_kept += solid.stock_facets;
    }
    return solid;
}

namespace {

// True if a further cut may help. With many facets, a cut takes long and only helps if the rest is
// recognised; with few facets, any facet given up is worth a cut.
bool are_facets_too_large(const brep::Recognised& solid, const Simulation& simulation) {
    constexpr std::size_t kMany = 20'000, kMost = 60'000, kFew = 100;
    const std::size_t facets = simulation.boundary->faces.size();
    return facets <= (solid.shells_kept == 0 ? kMost : kMany) &&
           solid.facets_demoted > (facets <= kMany ? 0 : solid.part.faces.size() / kFew);
}

// Factors of the tolerances of a further cut. Finer facets show more clearly which surfaces meet.
// Equally fine facets have other corners, which helps as often.
struct Cut {
    double of_tools, of_arcs;  // arcs and joined moves
};
constexpr std::array kCuts{Cut{0.25, 0.25}, Cut{0.0625, 0.0625}, Cut{0.5, 1.0},
                           Cut{1.0, 0.25},  Cut{0.5, 0.25},      Cut{0.25, 1.0}};
// No further cuts are made if the cuts so far have had more facets together, because the cost grows
// with the number of facets.
constexpr std::size_t kMostOfAllCuts = 60'000;

}  // namespace

Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, int most_refinements) {
    Solid best{solid_of(plan, survey, simulation, tolerance_mm), simulation.provenance,
               plan.tool_tolerance, plan.tolerance};
    bool is_coarse = are_facets_too_large(best.recognised, simulation);
    Plan other = plan;
    // cda-flat has quadratic cost in the facets; this model makes the same part.
    other.model = verifying_model().name;
    other.keep_boundary = true;
    other.keep_paths = other.keep_removed_cells = other.hull_times = false;
    other.tool_volumes = other.block_volumes = false;
    std::size_t facets = 0;
    const auto most = static_cast<std::size_t>(most_refinements);
    for (std::size_t i = 0; i < std::min(most, kCuts.size()) && is_coarse; ++i) {
        if (facets > kMostOfAllCuts) break;
        other.tool_tolerance = kCuts[i].of_tools * plan.tool_tolerance;
        other.tolerance = kCuts[i].of_arcs * plan.tolerance;
        other.join_tolerance = kCuts[i].of_arcs * plan.join_tolerance;
        Verification nothing;
        nothing.keep_cuts = true;
        nothing.history = simulation.history;
        Simulation again = simulate(other, survey, nothing, {});
        facets += again.boundary->faces.size();
        brep::Recognised solid = solid_of(other, survey, again, tolerance_mm);
        is_coarse = are_facets_too_large(solid, again);
        if (solid.facets_kept < best.recognised.facets_kept)
            best = {std::move(solid), std::move(again.provenance), other.tool_tolerance,
                    other.tolerance};
    }
    return best;
}

}  // namespace ncsim::simulation
