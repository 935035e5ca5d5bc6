// SPDX-License-Identifier: GPL-3.0-or-later
//
// A first look: how coarse it may be.
#pragma once

#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

namespace ncsim::simulation {

/// Makes the tolerances of a draft that nobody told as coarse as its picture allows, in which a
/// pixel is about a thousandth of the block, and joins moves; tools stay round. Leaves plans that
/// are no drafts.
void coarsen(Plan& plan, const Survey& survey, bool tolerance_told, bool tool_tolerance_told);

/// Where the model has a resolution that nobody told: the one that suits the stock. Throws
/// std::runtime_error if one that was told is too fine for it.
void choose_resolution(Plan& plan, const Survey& survey);

}  // namespace ncsim::simulation
