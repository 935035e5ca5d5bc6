// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of a program for all stages, from a single interpretation if the number of motions
// permits.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/simulation/plan.h"

#include <memory>
#include <vector>

namespace ncsim::simulation {

/// Keeps the motions of a program that passes by, up to a limit: a long program is cheaper to
/// interpret again than to keep.
class MotionRecorder {
public:
    void take(const gcode::Motion& motion);
    /// Returns the motions; null if there were more than the limit.
    std::shared_ptr<const std::vector<gcode::Motion>> result() &&;

private:
    std::vector<gcode::Motion> motions_;
    bool is_too_long_ = false;
};

/// Calls `sink` with each motion of the program, in the order of execution: from plan.motions, or
/// from an interpretation.
/// Requires: if plan.motions is set, plan.job.interpreter is unchanged since the survey.
void for_each_motion(const Plan& plan, const gcode::MotionSink& sink);

}  // namespace ncsim::simulation
