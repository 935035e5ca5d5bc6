// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours of cycles: the moves in the plane of a subprogram that is not executed.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/paths/path.h"
#include "language/milled_area.h"

namespace ncsim::gcode::language {

/// Collects the moves in a plane; the first move leads to the contour and is left out.
class ContourRecorder {
public:
    /// `unit_mm`: length of the unit of the contour, mm.
    ContourRecorder(Plane plane, double unit_mm) : axes_(axes_of(plane)), unit_mm_(unit_mm) {}

    /// Returns the sink of the motions. Requires: the recorder outlives the sink.
    MotionSink sink() {
        return [this](const Motion& motion) { add(motion); };
    }
    /// True if there is a first move to a known point.
    bool is_complete() const { return has_begun_ && is_known_; }
    /// Returns the contour. Requires: `is_complete()`.
    const Pass& contour() const { return moves_; }

private:
    void add(const Motion& motion);

    PlaneAxes axes_;
    double unit_mm_ = 1.0;
    bool has_begun_ = false;
    bool is_known_ = true;
    Pass moves_;
};

}  // namespace ncsim::gcode::language
