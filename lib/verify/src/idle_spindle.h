// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counter of cuts with a spindle that does not turn as the tool requires. Only the first 20 are
// searched, because a program without M3 has thousands and each search is expensive.
#pragma once

#include "ncsim/gcode/motion.h"

#include <cstdint>

namespace ncsim::verify {

class IdleSpindle {
public:
    /// Begins a motion; restarts the count if the spindle or the tool changes.
    void begin(const gcode::Motion& motion) {
        const State now{motion.tool, motion.spindle, motion.spindle_rpm, motion.spindle_in_doubt};
        if (now == state_) return;
        state_ = now;
        cuts_ = 0;
    }
    void count_cut() { ++cuts_; }
    bool is_specified() const { return cuts_ >= kMostCuts; }

private:
    static constexpr std::uint64_t kMostCuts = 20;
    struct State {
        int tool = 0;
        gcode::SpindleTurning spindle = gcode::SpindleTurning::Stopped;
        double rpm = 0.0;
        bool in_doubt = false;

        bool operator==(const State&) const = default;
    };
    State state_;
    std::uint64_t cuts_ = 0;
};

}  // namespace ncsim::verify
