// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy, model and resolution of a draft.
#pragma once

#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include <cstdint>

namespace ncsim::simulation {

/// Returns the work of an exact run of the program, in hulls of a flat end mill. A hull of a tool
/// without straight walls and a flat end counts as three, because it has about three times as many
/// planes. A move of an inclined tool counts as two, and a piece that rotates the tool as a
/// hundred.
///
/// Guarantees: the number depends on the program, its tools and `plan.tolerance` alone, not on the
/// computer.
double exact_work(const Plan& plan, const Survey& survey);

/// Largest exact_work() of a draft that is cut exactly: typically less than a second of CPU time.
inline constexpr double kQuickWork = 12'000.0;

/// Sets the unspecified tolerances of a draft to the accuracy of its picture, in which a pixel is
/// about a thousandth of the block, and joins moves; tools stay round. A draft of at most
/// kQuickWork with an exact model and no specified tolerance keeps the tolerances of an exact run,
/// and `plan.is_draft_exact` is set. Plans that are not drafts remain unchanged.
void coarsen(Plan& plan, const Survey& survey, bool tolerance_specified,
             bool tool_tolerance_specified);

/// Number of moves from which a draft uses a model of rays.
inline constexpr std::uint64_t kLongProgram = 200'000;

/// Chooses the model with a resolution for a draft of a long program, if no model is specified and
/// no result is requested that only exact models have.
void choose_model(Plan& plan, const Survey& survey);

/// Chooses the directions of rays if the model has rays and the directions are unspecified. Along Z
/// alone if no tool rotates or is wider below than above, and all tools have a round or a pointed
/// end, so the cuts leave slopes; otherwise along all axes, because of walls. Throws:
/// std::runtime_error if Z alone was specified and a tool rotates or undercuts.
void choose_rays(Plan& plan, const Survey& survey);

/// Chooses the resolution for the stock if the model has a resolution and none is specified.
/// Throws: std::runtime_error if the specified resolution is too fine.
void choose_resolution(Plan& plan, const Survey& survey);

}  // namespace ncsim::simulation
