// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts with a spindle that does not turn as the tool wants it. Some of them are told: a program
// without M3 has thousands, and each has to be asked for.
#pragma once

#include "ncsim/gcode/motion.h"

#include <cstdint>

namespace ncsim::verify {

class IdleSpindle {
public:
    /// A motion begins; counts anew where the spindle or the tool is another one.
    void begin(const gcode::Motion& motion) {
        const State now{motion.tool, motion.spindle, motion.spindle_rpm, motion.spindle_in_doubt};
        if (now == state_) return;
        state_ = now;
        cuts_ = 0;
    }
    void count_cut() { ++cuts_; }
    bool is_told() const { return cuts_ >= kMostCuts; }

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
