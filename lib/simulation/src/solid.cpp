// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognition of solids, with further cuts.
#include "ncsim/simulation/solid.h"

#include "ncsim/mesh/simplify.h"
#include "ncsim/simulation/models.h"

#include "sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ncsim::simulation {

brep::Recognised solid_of(const Plan& plan, const Survey& survey, const Simulation& simulation,
                          double tolerance_mm, std::uint64_t most_work) {
    // Facets in one plane need not be on a common surface: the bottoms of all grooves of a ball end
    // mill are in one plane. So facets of different motions stay separate, as with different lines.
    mesh::Provenance apart;
    for (std::uint32_t i = 0; i < simulation.provenance.entries.size(); ++i)
        apart.entries.push_back({i, 0});
    const auto facets = [&](double tolerance, const mesh::Provenance* lines) {
        mesh::JoinedFaces flat = mesh::join_faces(*simulation.boundary, tolerance, lines);
        return brep::Facets{std::move(flat.boundary), std::move(flat.origins)};
    };
    std::map<cda::Origin, brep::SweptSurfaces> sources;
    for_each_source(plan, survey, simulation, *simulation.boundary, tolerance_mm,
                    [&](cda::Origin origin, brep::SweptSurfaces source) {
                        sources[origin] = std::move(source);
                    });
    brep::Recognised solid = brep::recognise(
        facets(tolerance_mm, &apart), sources,
        [&](double times) { return facets(times * tolerance_mm, nullptr); }, most_work);
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
// Finer tools alone come first: these cuts have hardly more facets, and help most often.
constexpr std::array<Cut, kKnownCuts> kCuts{Cut{0.25, 1.0},      Cut{0.25, 0.25}, Cut{0.5, 1.0},
                                            Cut{0.0625, 0.0625}, Cut{1.0, 0.25},  Cut{0.5, 0.25}};
// No further cuts are made if the cuts so far have had more facets together, because the cost grows
// with the number of facets.
constexpr std::size_t kMostOfAllCuts = 60'000;

// Work in the unit of brep::Recognised::work, about 5 µs.
constexpr std::uint64_t kWorkOfRun = 1'600, kWorkOfHull = 3, kWorkOfFacet = 8;

// Returns the work of a run that writes a mesh.
std::uint64_t work_of(const Simulation& simulation) {
    return kWorkOfRun + kWorkOfHull * simulation.hulls +
           kWorkOfFacet * simulation.boundary->faces.size();
}

// Counted work of a solid, with limits relative to the work of the run without a solid.
class WorkBudget {
public:
    WorkBudget(const Simulation& simulation, bool is_limited)
        : plain_(work_of(simulation)), used_(plain_), is_limited_(is_limited) {}

    // Limit for recognise(). Solids without facets need less.
    std::uint64_t most_of_recognition() const {
        return is_limited_ ? std::max(2 * kLeast, plain_ + plain_ / 4) : brep::kUnlimitedWork;
    }

    void add(std::uint64_t work) { used_ += work; }

    // Decides by the first cut whether finer cuts are worth more: few facets fail, and many of the
    // kept facets do. The rest fits no surface, or is kept with its neighbours.
    void judge_first(const brep::Recognised& solid, const Simulation& simulation) {
        constexpr std::size_t kFew = 8;
        is_promising_ = kFew * solid.facets_demoted <= simulation.boundary->faces.size() &&
                        4 * solid.facets_demoted >= solid.facets_kept;
        has_lost_coils_ = solid.has_lost_coils;
    }

    // Records that a further cut did not help. Other tolerances of tools alone seldom do then.
    void add_failure() { is_promising_ = has_lost_coils_ = false; }

    // True if the cut is within the budget. Hulls and facets grow about with the fourth root of
    // both factors.
    bool allows(const Cut& cut) const {
        constexpr std::uint64_t kTimes = 3, kTimesOfToolsAlone = 9;
        if (!is_limited_) return true;
        const double growth = 1.0 / std::sqrt(std::sqrt(cut.of_tools * cut.of_arcs));
        const auto next = static_cast<std::uint64_t>(growth * static_cast<double>(plain_));
        const std::uint64_t times = cut.of_arcs == 1.0 ? kTimesOfToolsAlone : kTimes;
        // A single cut of the tools shows the flanks of threads.
        const std::uint64_t of_coils = has_lost_coils_ ? kTimes * plain_ + plain_ / 8 : 0;
        const std::uint64_t most =
            is_promising_ ? std::max(4 * kLeast, times * plain_) : std::max(kLeast, of_coils);
        return used_ + next <= most;
    }

private:
    static constexpr std::uint64_t kLeast = 12'000;  // for small parts

    std::uint64_t plain_, used_;
    bool is_limited_, is_promising_ = false, has_lost_coils_ = false;
};

// Returns the number of facets below which another solid is better. Shells of facets alone are
// exact, so an eighth of the facets is to go for surfaces that facets meet within their error.
std::size_t facets_to_beat(const brep::Recognised& solid) {
    return solid.facets_kept - (solid.shells_kept == 0 ? 0 : solid.facets_kept / 8);
}

// Returns the largest error of a tool's polygon, mm. Small tools have more sides than the tolerance
// needs, so finer tolerances are relative to this error.
double tool_error(const Plan& plan, const Simulation& simulation) {
    double error = 0.0;
    for (const auto& [tool, cutter] : simulation.cutters)
        error = std::max(error, cutter.error_mm);
    return error > 0.0 ? std::min(error, plan.tool_tolerance) : plan.tool_tolerance;
}

}  // namespace

Solid refined_solid(const Plan& plan, const Survey& survey, const Simulation& simulation,
                    double tolerance_mm, const Refinement& limit) {
    WorkBudget budget(simulation, limit.has_budget);
    Solid best{solid_of(plan, survey, simulation, tolerance_mm, budget.most_of_recognition()),
               simulation.provenance, plan.tool_tolerance, plan.tolerance};
    best.has_ended_early = best.recognised.has_ended_early;
    budget.add(best.recognised.work);
    budget.judge_first(best.recognised, simulation);
    bool is_coarse = are_facets_too_large(best.recognised, simulation);
    Plan other = plan;
    // cda-flat has quadratic cost in the facets; this model makes the same part.
    other.model = verifying_model().name;
    other.keep_boundary = true;
    other.keep_paths = other.keep_removed_cells = other.hull_times = false;
    other.tool_volumes = other.block_volumes = false;
    const double error = tool_error(plan, simulation);
    std::size_t facets = 0;
    const auto most = static_cast<std::size_t>(limit.most_cuts);
    int made = 0, not_tried = 0;
    for (std::size_t i = 0; i < std::min(most, kCuts.size()) && is_coarse; ++i) {
        if (facets > kMostOfAllCuts) break;
        if (!budget.allows(kCuts[i])) {
            ++not_tried;
            continue;
        }
        ++made;
        other.tool_tolerance = kCuts[i].of_tools * error;
        other.tolerance = kCuts[i].of_arcs * plan.tolerance;
        other.join_tolerance = kCuts[i].of_arcs * plan.join_tolerance;
        Verification nothing;
        nothing.keep_cuts = true;
        nothing.history = simulation.history;
        Simulation again = simulate(other, survey, nothing, {});
        facets += again.boundary->faces.size();
        brep::Recognised solid =
            solid_of(other, survey, again, tolerance_mm, budget.most_of_recognition());
        budget.add(work_of(again) + solid.work);
        is_coarse = are_facets_too_large(solid, again);
        const bool has_ended_early = solid.has_ended_early;
        if (solid.facets_kept < facets_to_beat(best.recognised)) {
            best = {std::move(solid), std::move(again.provenance), other.tool_tolerance,
                    other.tolerance};
            best.has_ended_early = has_ended_early;
        } else {
            budget.add_failure();
        }
    }
    best.cuts = made;
    best.cuts_not_tried = is_coarse ? not_tried : 0;
    return best;
}

}  // namespace ncsim::simulation
