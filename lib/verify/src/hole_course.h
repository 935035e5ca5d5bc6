// SPDX-License-Identifier: GPL-3.0-or-later
//
// Course of a tool along the axis in a hole: depth, and the way out of the cut.
#pragma once

#include "ncsim/gcode/motion.h"

#include "move.h"

#include <optional>

namespace ncsim::verify {

class HoleCourse {
public:
    /// Sets hole_depth_mm, leaves_cut, has_threaded and has_cut_below of `move`.
    /// Requires: `move` is measured.
    void take(Move& move);

private:
    int tool_ = 0;
    bool has_threaded_ = false;  // a helix in material, with this tool
    bool has_cut_ = false;       // at feed, along the axis, at (x_, y_)
    double x_ = 0.0, y_ = 0.0;
    std::optional<double> top_;  // Z of the first contact; empty: not in a hole
    // spindle state if the last motion cut straight down
    std::optional<gcode::SpindleTurning> cut_;
};

}  // namespace ncsim::verify
