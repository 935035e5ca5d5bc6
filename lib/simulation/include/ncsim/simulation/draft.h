// SPDX-License-Identifier: GPL-3.0-or-later
//
// A first look: how coarse it may be.
#pragma once

#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include <cstdint>

namespace ncsim::simulation {

/// Makes the tolerances of a draft that nobody told as coarse as its picture allows, in which a
/// pixel is about a thousandth of the block, and joins moves; tools stay round. Leaves plans that
/// are no drafts.
void coarsen(Plan& plan, const Survey& survey, bool tolerance_told, bool tool_tolerance_told);

/// Moves from which on a draft is made of rays.
inline constexpr std::uint64_t kLongProgram = 200'000;

/// A draft of a long program is made with the model that has a resolution, if nobody told another
/// and nothing is asked for that only others have.
void choose_model(Plan& plan, const Survey& survey);

/// Where the model has rays and nobody told their directions: along Z alone if no tool turns or is
/// wider below than above, and all have a round or a pointed end, so that slopes are what they
/// leave; along all axes where walls are. Throws std::runtime_error if Z alone was told and a tool
/// turns or undercuts.
void choose_rays(Plan& plan, const Survey& survey);

/// Where the model has a resolution that nobody told: the one that suits the stock. Throws
/// std::runtime_error if one that was told is too fine for it.
void choose_resolution(Plan& plan, const Survey& survey);

}  // namespace ncsim::simulation
