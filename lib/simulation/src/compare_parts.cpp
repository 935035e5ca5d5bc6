// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of two parts. The material of A that is not in B is the volume that the cells of B
// remove from A. So the second program is run on the finished part and measured, and its ledger
// gives the lines.
#include "ncsim/simulation/compare_parts.h"

#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/stock_history.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/verifier.h"

#include "compare_processes.h"
#include "motions.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

// Values of a motion that affect the part.
struct Trace {
    explicit Trace(const gcode::Motion& m)
        : action(m.action),
          kind(m.kind),
          tool(m.tool),
          coordinates(m.coordinates),
          known(m.known_start) {}
    decltype(gcode::Motion::action) action;
    gcode::MoveKind kind;
    int tool;
    gcode::Coordinates coordinates;
    gcode::KnownAxes known;
    bool operator==(const Trace&) const = default;
};

bool moves_alike(const SurveyedPlan& a, const SurveyedPlan& b) {
    // On specified machines, poses depend on more than the motions.
    if (a.plan.kinematics || b.plan.kinematics) return false;
    const auto same_tool = [](const auto& s, const auto& t) {
        return s.first == t.first && s.second.tool == t.second.tool;
    };
    if (!std::ranges::equal(a.survey.tools, b.survey.tools, same_tool)) return false;
    std::vector<Trace> traces;
    for_each_motion(a.plan, [&](const gcode::Motion& m) {
        if (gcode::start_of(m)) traces.emplace_back(m);
    });
    std::size_t next = 0;
    bool same = true;
    for_each_motion(b.plan, [&](const gcode::Motion& m) {
        if (!gcode::start_of(m) || !same) return;
        same = next < traces.size() && traces[next] == Trace(m);
        ++next;
    });
    return same && next == traces.size();
}

// Returns the material that the program of `side` still removes from the finished part of `other`.
// `rest` becomes the material of both parts.
OneSidedMaterial remainder(const SurveyedPlan& side, const Simulation& other,
                           std::unique_ptr<cda::WorkpieceModel>& rest) {
    verify::Setup setup;
    setup.ledger = true;
    for (const verify::RuleInfo& rule : verify::rules())
        setup.selection.ignored.emplace(rule.id, "");
    for (const auto& [number, used] : side.survey.tools)
        setup.tools[number].tool = used.tool;
    verify::Verifier verifier(setup, side.survey.stock->box, other.lattice);
    Verification verification;
    verification.verifier = &verifier;
    verification.start = other.part.get();
    Simulation cut = simulate(side.plan, side.survey, verification, {});
    const verify::Verdict verdict =
        verifier.finish(side.survey.interpretation, cut.part.get(), cut.stock_volume);
    OneSidedMaterial result;
    result.regions = verify::regions_of(verdict.ledger);
    result.volume_mm3 = verdict.ledger.removed_mm3;
    result.files = verdict.files;
    rest = std::move(cut.part);
    return result;
}

}  // namespace

Comparison compare_with_parts(const SurveyedPlan& a, const SurveyedPlan& b) {
    require_verifying(a.plan);
    require_verifying(b.plan);
    Comparison result;
    Difference& d = result.difference;
    d.process = compare_processes(a.plan, a.survey, b.plan, b.survey);
    Verification verification;
    verification.keep_cuts = true;
    verification.history = read_stock_history(*a.survey.stock);
    result.old_part = simulate(a.plan, a.survey, verification, {});
    d.old_mm3 = result.old_part.part_volume;
    d.same_motions = moves_alike(a, b);
    if (d.same_motions) {
        d.new_mm3 = d.old_mm3;
        return result;
    }
    verification.history = read_stock_history(*b.survey.stock);
    result.new_part = simulate(b.plan, b.survey, verification, {});
    d.new_mm3 = result.new_part.part_volume;
    d.only_old = remainder(b, result.old_part, result.common);
    d.only_new = remainder(a, result.new_part, result.common);
    return result;
}

Difference compare_parts(const SurveyedPlan& a, const SurveyedPlan& b) {
    return compare_with_parts(a, b).difference;
}

}  // namespace ncsim::simulation
