// SPDX-License-Identifier: GPL-3.0-or-later
//
// For drafts: short moves in a row that lie on one line, as well as a picture shows it, become one.
// Posts that write a curve as points a tenth of a millimetre apart make a program of a thousand
// cuts where fifty look the same.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/interpreter.h"

#include <optional>
#include <vector>

namespace ncsim::simulation {

class MoveJoiner {
public:
    /// Hands motions on to `sink`, in order. A joined move stays within `tolerance_mm` of every
    /// place that it stands for, comes by them in order, and has the block of its first; 0 joins
    /// nothing.
    MoveJoiner(double tolerance_mm, gcode::MotionSink sink);

    /// Cost: what a row has so far, 256 places at most.
    void take(const gcode::Motion& motion);
    /// After the last motion.
    void flush();
    /// Were any?
    bool has_joined() const { return has_joined_; }

private:
    bool can_join(const gcode::Motion& next) const;

    double tolerance_mm_;
    gcode::MotionSink sink_;
    std::optional<gcode::Motion> held_;  ///< From the start of the row to where it ends by now.
    std::vector<cda::Vec3> passed_;      ///< Places between, mm.
    bool has_joined_ = false;
};

}  // namespace ncsim::simulation
