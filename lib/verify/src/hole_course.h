// SPDX-License-Identifier: GPL-3.0-or-later
//
// Course of a tool along its axis in one hole: depth, and the way out of the cut.
#pragma once

#include "ncsim/gcode/motion.h"

#include "move.h"

#include <optional>

namespace ncsim::verify {

class HoleCourse {
public:
    /// Sets hole_depth_mm and leaves_cut of `move`.
    /// Requires: `move` is measured.
    void take(Move& move);

private:
    int tool_ = 0;
    double x_ = 0.0, y_ = 0.0;
    std::optional<double> top_;  // Z of the first contact; empty: not in a hole
    // spindle state if the last motion cut straight down
    std::optional<gcode::SpindleTurning> cut_;
};

}  // namespace ncsim::verify
