// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about the cut of a part: model and tolerances.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <optional>
#include <string>

namespace ncsim::report {

/// Model and tolerances of the cut.
struct CuttingFacts {
    std::string model;
    double resolution = 0.0;              ///< Resolution of the model, mm; 0 if the model has none.
    bool has_rays_along_z_alone = false;  ///< True if there are no rays along X and Y.
    bool is_model_chosen = false;  ///< True if the model was chosen because the program is long.
    double tolerance = 0.0;        ///< Tolerance of chords and of rotary moves, mm.
    double tool_tolerance = 0.0;   ///< Tolerance of round tools, mm.
    /// Consecutive moves within this distance of a line are joined, mm; 0: no moves are joined.
    double join_tolerance = 0.0;
    bool is_draft_exact = false;  ///< True for a draft of a short program, which is cut exactly.
    std::optional<std::uint32_t> at_line;      ///< Line after which the simulation was stopped.
    LengthUnit unit = LengthUnit::Millimetre;  ///< Unit of texts; all values here are in mm.
};

/// Returns the facts of a cut by `plan`, for texts in mm.
CuttingFacts cutting_facts(const simulation::Plan& plan);

}  // namespace ncsim::report
