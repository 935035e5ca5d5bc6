// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/solid.h"

#include "ncsim/brep/swept.h"
#include "ncsim/export/simplify.h"

#include "join_moves.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

// Of the origins that faces name: the stock, and motions.
std::map<cda::Origin, brep::Source> sources_of(const Plan& plan, const Survey& survey,
                                               const Simulation& simulation, double tolerance_mm) {
    // Of the lattice, and of what sums of these lack in accuracy.
    constexpr double kRounding = 1e-3;
    const double rounding = kRounding + tolerance_mm;
    std::map<cda::Origin, brep::Source> sources;
    std::vector<bool> is_there(simulation.cuts.size(), false);
    for (const cda::BoundaryFace& face : simulation.boundary->faces) {
        const auto origin = static_cast<std::size_t>(face.origin);
        if (origin < is_there.size()) is_there[origin] = true;
    }
    sources[cda::kStockOrigin] = {brep::surfaces_of(*survey.stock), plan.tool_tolerance + rounding};
    std::uint64_t motions = 0;
    std::size_t next = 1;
    MoveJoiner joiner(plan.join_tolerance, [&](const gcode::Motion& motion) {
        ++motions;
        if (next >= simulation.cuts.size() || simulation.cuts[next].motion != motions) return;
        const std::size_t origin = next++;
        const auto tool = survey.tools.find(motion.tool);
        if (!is_there[origin] || tool == survey.tools.end()) return;
        const auto cutter = simulation.cutters.find(motion.tool);
        const double polygon =
            cutter == simulation.cutters.end() ? plan.tool_tolerance : cutter->second.error_mm;
        sources[cda::Origin{static_cast<std::uint32_t>(origin)}] = {
            brep::surfaces_of(motion, tool->second.tool),
            polygon + plan.tolerance + plan.join_tolerance + rounding};
    });
    gcode::interpret(plan.job.program, plan.job.interpreter,
                     [&](const gcode::Motion& motion) { joiner.take(motion); });
    joiner.flush();
    return sources;
}

}  // namespace

brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm) {
    // What lies in one plane is not yet of one surface: the bottoms of all grooves of a ball do. So
    // facets of different motions stay apart, as lines would.
    exporter::Provenance apart;
    for (std::uint32_t i = 0; i < simulation.provenance.entries.size(); ++i)
        apart.entries.push_back({i, 0});
    const auto facets = [&](const exporter::Provenance* lines) {
        exporter::Simplified flat = exporter::simplify(*simulation.boundary, tolerance_mm, lines);
        return brep::Facets{std::move(flat.boundary), std::move(flat.origins)};
    };
    return brep::recognise(facets(&apart), sources_of(plan, survey, simulation, tolerance_mm),
                           [&] { return facets(nullptr); });
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

}  // namespace

Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, int most_refinements) {
    Solid best{solid_of(plan, survey, simulation, tolerance_mm), simulation.provenance,
               plan.tool_tolerance};
    bool is_coarse = are_facets_too_large(best.recognised, simulation);
    Plan finer = plan;
    finer.keep_boundary = true;
    finer.keep_paths = finer.keep_carved = finer.block_volumes = finer.hull_times = false;
    for (int i = 0; i < most_refinements && is_coarse; ++i) {
        finer.tool_tolerance *= 0.25;
        finer.tolerance *= 0.25;
        Verification nothing;
        nothing.keep_cuts = true;
        Simulation again = simulate(finer, survey, nothing, {});
        brep::Recognised solid = solid_of(finer, survey, again, tolerance_mm);
        is_coarse = are_facets_too_large(solid, again);
        if (solid.facets_kept >= best.recognised.facets_kept) continue;
        best = {std::move(solid), std::move(again.provenance), finer.tool_tolerance};
    }
    return best;
}

}  // namespace ncsim::simulation
