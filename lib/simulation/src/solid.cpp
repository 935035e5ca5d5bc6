// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/solid.h"

#include "ncsim/export/simplify.h"

#include "sources.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm) {
    // What lies in one plane is not yet of one surface: the bottoms of all grooves of a ball do. So
    // facets of different motions stay apart, as lines would.
    exporter::Provenance apart;
    for (std::uint32_t i = 0; i < simulation.provenance.entries.size(); ++i)
        apart.entries.push_back({i, 0});
    const auto facets = [&](double tolerance, const exporter::Provenance* lines) {
        exporter::Simplified flat = exporter::simplify(*simulation.boundary, tolerance, lines);
        return brep::Facets{std::move(flat.boundary), std::move(flat.origins)};
    };
    std::map<cda::Origin, brep::Source> sources;
    for_each_source(
        plan, survey, simulation, *simulation.boundary, tolerance_mm,
        [&](cda::Origin origin, brep::Source source) { sources[origin] = std::move(source); });
    return brep::recognise(facets(tolerance_mm, &apart), sources,
                           [&](double times) { return facets(times * tolerance_mm, nullptr); });
}

namespace {

// Of many facets a finer cut takes long, and helps where the rest is known; of few it is worth it
// for any.
bool are_facets_too_large(const brep::Recognised& solid, const Simulation& simulation) {
    constexpr std::size_t kMany = 20'000, kMost = 60'000, kFew = 100;
    const std::size_t facets = simulation.boundary->faces.size();
    return facets <= (solid.shells_kept == 0 ? kMost : kMany) &&
           solid.facets_given_up > (facets <= kMany ? 0 : solid.part.faces.size() / kFew);
}

// Of so many facets another cut takes no time to speak of. Finer ones are more where they stay, and
// so tell nothing of what the next cut does.
constexpr std::size_t kCheap = 2'000;

}  // namespace

Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, int most_refinements) {
    Solid best{solid_of(plan, survey, simulation, tolerance_mm), simulation.provenance,
               plan.tool_tolerance};
    bool is_coarse = are_facets_too_large(best.recognised, simulation);
    Plan finer = plan;
    finer.keep_boundary = true;
    finer.keep_paths = finer.keep_carved = finer.block_volumes = finer.hull_times = false;
    bool is_cheap = true;
    for (int i = 0; i < most_refinements && is_coarse && (is_cheap || i < 2); ++i) {
        finer.tool_tolerance *= 0.25;
        finer.tolerance *= 0.25;
        Verification nothing;
        nothing.keep_cuts = true;
        Simulation again = simulate(finer, survey, nothing, {});
        brep::Recognised solid = solid_of(finer, survey, again, tolerance_mm);
        is_coarse = are_facets_too_large(solid, again);
        is_cheap = again.boundary->faces.size() <= kCheap;
        // What did not help once hardly ever does.
        if (solid.facets_kept >= best.recognised.facets_kept) {
            if (!is_cheap) break;
            continue;
        }
        best = {std::move(solid), std::move(again.provenance), finer.tool_tolerance};
    }
    return best;
}

}  // namespace ncsim::simulation
