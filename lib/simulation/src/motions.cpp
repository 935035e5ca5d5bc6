// SPDX-License-Identifier: GPL-3.0-or-later
//
// Record of motions, and interpretation of programs too long for a record.
#include "motions.h"

#include "ncsim/gcode/interpreter.h"

#include <cstddef>
#include <utility>

namespace ncsim::simulation {

namespace {

constexpr std::size_t kMostKept = 100'000;  // 40 MB

}  // namespace

void MotionRecorder::take(const gcode::Motion& motion) {
    if (is_too_long_) return;
    is_too_long_ = motions_.size() == kMostKept;
    if (is_too_long_)
        motions_ = {};
    else
        motions_.push_back(motion);
}

std::shared_ptr<const std::vector<gcode::Motion>> MotionRecorder::result() && {
    if (is_too_long_) return nullptr;
    motions_.shrink_to_fit();
    return std::make_shared<const std::vector<gcode::Motion>>(std::move(motions_));
}

void for_each_motion(const Plan& plan, const gcode::MotionSink& sink) {
    if (!plan.motions) {
        (void)gcode::interpret(plan.job.program, plan.job.interpreter, sink);
        return;
    }
    for (const gcode::Motion& motion : *plan.motions)
        sink(motion);
}

}  // namespace ncsim::simulation
