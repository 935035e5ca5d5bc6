// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the parts that two programs make.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/simulation/difference.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"

#include <memory>

namespace ncsim::simulation {

/// A plan with the survey of its program.
struct SurveyedPlan {
    Plan plan;
    Survey survey;
};

/// Difference of two parts, with the parts.
struct Comparison {
    Difference difference;
    Simulation old_part;  ///< With its cuts.
    /// The same; without a part if both programs make the same motions with the same tools.
    Simulation new_part;
    /// Material of both parts; null if both programs make the same motions with the same tools.
    std::unique_ptr<cda::WorkpieceModel> common;
};

/// Returns the material that only one of the parts has, and the lines of the program that removed
/// the material. Names, tolerance and conclusions are left to the caller.
/// Requires: both programs are ready and have the same stock. Throws: std::invalid_argument if a
/// model does not verify. Cost: up to two simulations of each program; of `a` alone if both make
/// the same motions with the same tools.
Comparison compare_with_parts(const SurveyedPlan& a, const SurveyedPlan& b);
/// Returns the difference of compare_with_parts().
Difference compare_parts(const SurveyedPlan& a, const SurveyedPlan& b);

}  // namespace ncsim::simulation
