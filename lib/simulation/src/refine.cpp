// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides open contacts by simulations of small boxes.
#include "refine.h"

#include "ncsim/cda/polytope.h"
#include "ncsim/cda/shape.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/verifier.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace ncsim::simulation {

namespace {

using verify::Certainty;

// Returns the part of the stock in `box` (mm).
toolpath::Stock crop_stock(const toolpath::Stock& stock, const Box& box, double tolerance_mm) {
    auto shape = std::make_shared<cda::Shape>(toolpath::stock_shape(stock, tolerance_mm));
    const cda::Lattice& lattice = shape->lattice;
    const cda::Cell sides = cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice);
    for (const cda::Plane& plane : sides.planes) {
        if (std::ranges::find(shape->outer.planes, plane) == shape->outer.planes.end())
            shape->outer.planes.push_back(plane);
    }
    shape->outer.normals.reset();
    shape->outer.bounds = sides.bounds;
    std::erase_if(shape->carved,
                  [&sides](const cda::Cell& cell) { return !cell.bounds.overlaps(sides.bounds); });
    toolpath::Stock part = stock;
    part.box = sides.bounds;
    part.shape = std::move(shape);
    return part;
}

}  // namespace

Refiner::Refiner(const Plan& plan, const Survey& survey, const verify::Setup& setup)
    : plan_(&plan),
      survey_(&survey),
      setup_(&setup),
      steps_left_(std::max(kLeastSteps, kStepsPerMove * survey.moves)) {}

verify::ContactDecision Refiner::decide(const verify::OpenContact& contact) {
    bool is_open = false;
    for (const Box& box : contact.boxes) {
        verify::ContactDecision seen = Certainty::Within;
        for (const double factor : {16.0, 256.0}) {
            if (seen != Certainty::Within) break;
            if (refinements_++ >= kMaxRefinements) return Certainty::Within;
            seen = refine_once(contact, box, factor);
        }
        if (seen == Certainty::Certain) return seen;
        is_open |= seen.has_value();
    }
    return is_open ? verify::ContactDecision(Certainty::Within) : std::nullopt;
}

verify::ContactDecision Refiner::refine_once(const verify::OpenContact& contact, const Box& box,
                                             double factor) {
    const auto finer = [factor](double mm) {
        constexpr double kFinest = 1e-5;
        return std::max(mm / factor, kFinest);
    };
    Plan plan = *plan_;
    plan.tiles = nullptr;  // the box is cut here
    plan.tool_tolerance = finer(plan.tool_tolerance);
    plan.tolerance = finer(plan.tolerance);
    Survey survey = *survey_;
    static_cast<toolpath::Stock&>(*survey.stock) =
        crop_stock(*survey.stock, box, plan.tool_tolerance);
    const cda::Shape& shape = *survey.stock->shape;
    // A bar of finer tolerance may not reach the box.
    if (!cda::ConvexPolytope::of(shape.outer, shape.lattice)) return std::nullopt;

    verify::Setup setup;
    setup.tools = setup_->tools;
    auto& pieces = setup.tools.at(contact.tool).tool.pieces;
    for (std::size_t i = pieces.size(); i-- > 0;) {
        if (!pieces[i].cutting && contact.piece != i)
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (const verify::RuleInfo& rule : verify::rules()) {
        if (rule.id != contact.rule) setup.selection.ignored.emplace(rule.id, "");
    }
    setup.rapid = setup_->rapid;
    setup.kinematics = setup_->kinematics;
    const toolpath::WatchedParts watch = verify::watched_parts(setup);
    setup.accuracy.tolerance_mm = plan.tool_tolerance;
    verify::Verifier verifier(std::move(setup), survey.stock->box,
                              toolpath::stock_lattice(*survey.stock));
    Verification verification;
    verification.side = toolpath::Side::Circumscribed;
    verification.verifier = &verifier;
    verification.rapid = setup_->rapid;
    verification.watch = watch;
    verification.only_motion = contact.motion;
    verification.most_steps = steps_left_;
    try {
        steps_left_ -= simulate(plan, survey, verification, {}).steps;
    } catch (const StepLimit&) {
        steps_left_ = 0;
        return Certainty::Within;
    }
    const verify::Verdict verdict = verifier.finish(survey.interpretation, nullptr, 0.0);
    verify::ContactDecision seen;
    for (const verify::Finding& f : verdict.findings) {
        if (f.rule != contact.rule) continue;
        if (f.certainty == Certainty::Certain) return Certainty::Certain;
        seen = Certainty::Within;
    }
    return seen;
}

}  // namespace ncsim::simulation
