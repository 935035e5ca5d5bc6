// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data for the review of a changed program: pictures, values, and lines of both programs.
#pragma once

#include "ncsim/simulation/compare_parts.h"
#include "ncsim/simulation/review.h"

namespace ncsim::simulation {

/// Returns the review of a comparison of `a` (old) and `b` (new). Pictures have the same camera
/// before and after: isometric, and the view along an axis that shows most of the difference.
/// Guarantees: the same bytes for any number of threads.
/// Throws: std::runtime_error if a picture cannot be drawn.
Review review_of(const SurveyedPlan& a, const SurveyedPlan& b, Comparison comparison);

}  // namespace ncsim::simulation
